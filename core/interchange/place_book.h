// Names for the places of a plan that is written as a table or an outline.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// A named Point of a plan's document that is no thing of the plan.
struct Landmark {
  std::string name;
  std::string coordinates;
  std::size_t index = 0;  // among the document's Placemarks
};

struct BookedPlace {
  std::string name, lon, lat;  // degrees, with the digits of the plan
};

class PlaceBook {
 public:
  // Names places: assets by their ids, landmarks, then where events are or end by their labels ("To
  // Ridge" leads to Ridge), where rovers start, and P1, P2, ... No two names differ only in case.
  PlaceBook(const KmlSource& things, const Declarations& declarations,
            const std::vector<Landmark>& landmarks);

  // What the column Place says of the thing with that index: "Ridge", or "Ridge; Gate" for a line
  // of a few places; "" where its coordinates have to be written.
  const std::string& text(std::size_t index) const { return texts_[index]; }
  // The places that are named so, without assets, in the order of their naming.
  std::vector<BookedPlace> used() const;

 private:
  struct Entry {
    BookedPlace place;
    bool is_asset = false;
  };

  void add_asset(const SourcePlacemark& asset);
  void add(const std::string& name, const std::string& coordinates);
  void add_labels();
  std::string name_of(const std::string& tuple, bool only_used) const;
  // The text of a thing that stands at the place `before` before it; marks its places as used.
  std::string named(const SourcePlacemark& thing, const std::string& before);

  const KmlSource& things_;
  const Declarations& declarations_;
  std::vector<std::string> texts_;       // of the column Place
  std::map<std::string, Entry> places_;  // by key, see place_key()
  std::vector<std::string> order_;       // keys
  std::set<std::string> taken_, used_;   // names in small letters; keys
};

// The landmarks of a plan's document.
std::vector<Landmark> landmarks(const KmlSource& source, const Declarations& declarations);

}  // namespace lsos

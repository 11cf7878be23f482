// A KML document that is changed in places: what is not touched stays as it was, with its blanks,
// comments and foreign elements. The only code that knows libxml2.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct _xmlDoc;
struct _xmlNode;

namespace lsos {

// An element of a KmlDom; valid until it is removed.
using KmlElement = _xmlNode*;

class KmlDom {
 public:
  // `utf8`: a document that parse_kml() accepts. Nothing outside it is read, no entity replaced.
  // Throws InputError where it is no well-formed XML, for messages in `file`.
  KmlDom(const std::string& utf8, const std::string& file);
  ~KmlDom();
  KmlDom(const KmlDom&) = delete;
  KmlDom& operator=(const KmlDom&) = delete;

  // The document as UTF-8.
  std::string text() const;

  KmlElement root() const;
  // The Placemarks in the order in which parse_kml() gives them.
  std::vector<KmlElement> placemarks() const;
  // Shared by the whole document: <Schema>, <Style>, <StyleMap> of <kml> and its <Document>s.
  std::vector<KmlElement> shared(std::string_view name) const;
  // What holds its features: the outermost <Document>, else the outermost element.
  KmlElement container() const;

  // Copies an element, of this or another document, with all in it, behind `after`, with the blanks
  // that stand before that one. An XML id is not copied.
  KmlElement copy_behind(KmlElement element, KmlElement after);
  // The same before another element, or as the last in `parent`.
  KmlElement copy_before(KmlElement element, KmlElement before);
  KmlElement copy_into(KmlElement element, KmlElement parent);
  // A new element as the last in `parent`, in its namespace.
  KmlElement add(KmlElement parent, const char* name, std::string_view text);
  // The same as the first.
  KmlElement add_first(KmlElement parent, const char* name, std::string_view text);
  // A new element of a Placemark or Folder, in the place that KML's schema gives to one of that
  // name: after those that come before it, and before all others.
  KmlElement add_feature_part(KmlElement feature, const char* name, std::string_view text);
  // Likewise a copy.
  KmlElement copy_as_feature_part(KmlElement element, KmlElement feature);
  // With the blanks before it.
  void remove(KmlElement element);

 private:
  struct Free {
    void operator()(_xmlDoc* document) const;
  };
  std::unique_ptr<_xmlDoc, Free> document_;
  bool has_declaration_ = false;  // <?xml ... ?>
  bool has_crlf_ = false;         // its lines end as those of Windows
};

// Name without prefix.
std::string_view local_name(KmlElement element);
std::vector<KmlElement> children(KmlElement parent);
// The first child element of that name; nullptr when there is none.
KmlElement child(KmlElement parent, std::string_view name);
KmlElement parent_of(KmlElement element);
// Trimmed; "" when there is none.
std::string attribute(KmlElement element, const char* name);
void set_attribute(KmlElement element, const char* name, const std::string& value);
// Text and CDATA directly in the element, trimmed.
std::string text_of(KmlElement element);
// Puts another text in place of that between the blanks around it.
void set_text(KmlElement element, const std::string& text);
// Puts a text behind what stands in the element, which keeps its CDATA.
void append_text(KmlElement element, const std::string& text);
// Takes away what was appended: from `begin` to `end`, with both. Returns whether it was there.
bool erase_text(KmlElement element, std::string_view begin, std::string_view end);
// The texts of coordinates of a Placemark's geometry, of Points, lines and rings; none where its
// place stands in something else (gx:Track, Camera).
std::vector<KmlElement> coordinates_of(KmlElement placemark);
// Calls `visit` with all elements in `parent`, at any depth.
void for_each_element(KmlElement parent, const std::function<void(KmlElement)>& visit);
// The element as XML, for comparison.
std::string xml_of(KmlElement element);

}  // namespace lsos

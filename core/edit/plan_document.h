// A plan's KML document that is edited: its Placemarks with their fields, beside the values that
// the plan was read as.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "edit/kml_dom.h"
#include "plan/plan.h"

namespace lsos {

// A Placemark of the plan in its document.
struct PlanMark {
  KmlElement element = nullptr;
  std::string type;        // MissionInfo, Rover, Asset or an event type
  std::string schema_url;  // of the SchemaData with its fields; "": they stand in any, or in Data
  Place place = {};        // in the file that was read; of a copy, that of what was copied
};

class PlanDocument {
 public:
  // `kml`: the document that `plan` was read from, without errors. The plan and the declarations
  // must outlive it. Throws InputError where it is no well-formed XML.
  PlanDocument(const std::string& kml, const Plan& plan, const Declarations& declarations);

  const Plan& plan() const { return plan_; }
  const Declarations& declarations() const { return declarations_; }
  KmlDom& dom() { return dom_; }
  std::string text() const { return dom_.text(); }

  const PlanMark& mission() const { return mission_; }
  const PlanMark& rover(const std::string& id) const { return rovers_.at(id); }
  const PlanMark& asset(const std::string& id) const { return assets_.at(id); }
  const PlanMark& mark(const PlanEvent& event) const {
    return events_.at({event.rover_id, event.sequence});
  }

  // Rasters that MissionInfo names relative to the plan are named relative to the folder of `file`,
  // where the document is to be.
  void follow_rasters(const std::string& file);

  // The field's text, trimmed; "" when it is absent.
  std::string field(const PlanMark& mark, const std::string& name) const;
  // Writes a field; one that is new is declared in its <Schema> too, where there is one.
  void set_field(const PlanMark& mark, const std::string& name, const std::string& text);
  void erase_field(const PlanMark& mark, const std::string& name);
  // The Placemark's name; "" when it has none, and the event its default label.
  std::string name(const PlanMark& mark) const;
  void set_name(const PlanMark& mark, const std::string& text);

 private:
  std::vector<KmlElement> fields(const PlanMark& mark, const std::string& name) const;
  void declare(const PlanMark& mark, const std::string& name);

  const Plan& plan_;
  const Declarations& declarations_;
  KmlDom dom_;
  PlanMark mission_;
  std::map<std::string, PlanMark> rovers_, assets_;
  std::map<PlanEvent::Reference, PlanMark> events_;
};

}  // namespace lsos

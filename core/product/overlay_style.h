// Styles of an overlay's lines and points.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plan/kml_writer.h"
#include "product/overlay_icons.h"
#include "record/rows.h"

namespace lsos {

// Style id of events with that status, for all rovers: "event-failed", "event-failed-unlabelled".
std::string status_style_id(EventStatus status, bool has_label);
KmlStyle status_style(EventStatus status, bool has_label, IconPlace icon_href);

// Style of notes that warn: red.
inline constexpr const char* warning_style_id = "note-warning";
KmlStyle warning_style(IconPlace icon_href);

// The styles of one rover. Its colour depends on its index `i` among the rovers.
struct RoverStyle {
  std::string plan_id, planned_id, driven_id, sample_id, track_id;

  explicit RoverStyle(std::size_t i);
  void add_to(std::vector<KmlStyle>& styles, IconPlace icon_href) const;

 private:
  std::string color_;
};

}  // namespace lsos

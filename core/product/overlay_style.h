// How lines and points of an overlay look.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plan/kml_writer.h"
#include "product/overlay_icons.h"
#include "record/rows.h"

namespace lsos {

// How events that ended so look, whatever the rover: "event-failed", "event-failed-unlabelled".
std::string status_style_id(EventStatus status, bool has_label);
KmlStyle status_style(EventStatus status, bool has_label, IconPlace icon_href);

// The styles of one rover; its colour goes by its place among the rovers.
struct RoverStyle {
  std::string plan_id, planned_id, driven_id, event_id, sample_id, track_id;

  explicit RoverStyle(std::size_t i);
  void add_to(std::vector<KmlStyle>& styles, IconPlace icon_href) const;

 private:
  std::string color_;
};

}  // namespace lsos

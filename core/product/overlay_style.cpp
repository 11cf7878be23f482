#include "product/overlay_style.h"

#include <fmt/format.h>

#include "picture/rover_colors.h"

namespace lsos {

namespace {

constexpr const char* red_abgr = "ff1c19d7";

}  // namespace

std::string status_style_id(EventStatus status, bool has_label) {
  return fmt::format("event-{}{}", to_string(status), has_label ? "" : "-unlabelled");
}

KmlStyle status_style(EventStatus status, bool has_label, IconPlace icon_href) {
  KmlStyle style;
  style.id = status_style_id(status, has_label);
  style.icon_scale = 0.8;
  style.label_scale = has_label ? 0.8 : 0;
  switch (status) {
    case EventStatus::completed:
      style.icon_color_abgr = "ff3c9600";
      style.icon_href = icon_href(OverlayIcon::disc);
      break;
    case EventStatus::failed:
      style.icon_color_abgr = red_abgr;
      style.icon_href = icon_href(OverlayIcon::cross);
      break;
    case EventStatus::incomplete:
      style.icon_color_abgr = "ff008cff";
      style.icon_href = icon_href(OverlayIcon::square);
      break;
    default:
      style.icon_color_abgr = "ff969696";
      style.icon_href = icon_href(OverlayIcon::diamond);
  }
  return style;
}

KmlStyle warning_style(IconPlace icon_href) {
  KmlStyle style;
  style.id = warning_style_id;
  style.icon_color_abgr = red_abgr;
  style.icon_href = icon_href(OverlayIcon::diamond);
  style.icon_scale = style.label_scale = 0.8;
  return style;
}

RoverStyle::RoverStyle(std::size_t i)
    : plan_id(fmt::format("plan-{}", i)),
      planned_id(fmt::format("planned-{}", i)),
      driven_id(fmt::format("driven-{}", i)),
      sample_id(fmt::format("sample-{}", i)),
      track_id(fmt::format("track-{}", i)),
      color_(rover_colors[i % rover_colors.size()]) {}

void RoverStyle::add_to(std::vector<KmlStyle>& styles, IconPlace icon_href) const {
  KmlStyle plan;
  plan.id = plan_id;
  plan.line_color_abgr = "80" + color_;
  plan.line_width = 5;
  KmlStyle planned;
  planned.id = planned_id;
  planned.line_color_abgr = "ffffffff";
  KmlStyle driven;
  driven.id = driven_id;
  driven.line_color_abgr = "ff" + color_;
  KmlStyle sample;
  sample.id = sample_id;
  sample.icon_color_abgr = "c0" + color_;
  sample.icon_href = icon_href(OverlayIcon::arrow);
  sample.icon_scale = 0.35;
  sample.label_scale = 0;  // thousands of labels would hide the ground
  // The line behind the moving icon has the same colour.
  KmlStyle track;
  track.id = track_id;
  track.icon_color_abgr = "ff" + color_;
  track.icon_href = icon_href(OverlayIcon::arrow);
  track.line_color_abgr = "ff" + color_;
  styles.insert(styles.end(), {plan, planned, driven, sample, track});
}

}  // namespace lsos

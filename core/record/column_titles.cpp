#include "record/column_titles.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace lsos {

namespace {

constexpr std::array titles{
    ColumnTitle{"amount", "Amount", "of a resource aboard, in the resource's own unit"},
    ColumnTitle{"angle_rad", "Angle, rad"},
    ColumnTitle{"attempt", "Attempt", "how often the leg had been planned before"},
    ColumnTitle{"azimuth_rad", "Azimuth, rad", "of the panel's face, clockwise from true north"},
    ColumnTitle{"charge", "Charge, 0 to 1", "what the battery holds, of its capacity"},
    ColumnTitle{"distance_m", "Distance, m", "driven along the ground; of pairs: between the two"},
    ColumnTitle{"drive_j", "Driving, J", "drive_w since the start"},
    ColumnTitle{"drive_w", "Driving, W", "what the wheel motors take"},
    ColumnTitle{"duration_s", "Duration, s", "as planned"},
    ColumnTitle{"elevation_m", "Elevation, m", "of the ground, in the terrain's datum"},
    ColumnTitle{"elevation_rad", "Elevation, rad", "of the panel's face above the horizon"},
    ColumnTitle{"end_s", "End, s", "since the mission's start"},
    ColumnTitle{"end_utc", "End, UTC"},
    ColumnTitle{"energy_j", "Energy, J", "what the battery holds; of planned paths: of driving it"},
    ColumnTitle{"energy_rate_w", "Energy rate, W", "into the battery; negative: out of it"},
    ColumnTitle{"energy_used_j", "Energy used, J", "loads, driving and losses"},
    ColumnTitle{"event", "Event", "label of the event that runs"},
    ColumnTitle{"extension_m", "Extension, m"},
    ColumnTitle{"external_j", "From outside, J", "external_w since the start"},
    ColumnTitle{"external_w", "From outside, W"},
    ColumnTitle{"fields", "Fields", "of the note, JSON"},
    ColumnTitle{"from_id", "From"},
    ColumnTitle{"heading_rad", "Heading, rad", "clockwise from true north"},
    ColumnTitle{"incidence", "Solar incidence", "sunlit share of the panels times the cosine"},
    ColumnTitle{"joint", "Joint"},
    ColumnTitle{"key", "Key"},
    ColumnTitle{"kind", "Kind", "visible: seen; link: joined, directly or by relays"},
    ColumnTitle{"label", "Event"},
    ColumnTitle{"lat_deg", "Latitude, degrees"},
    ColumnTitle{"leg", "Leg", "the waypoint that it leads to"},
    ColumnTitle{"length_m", "Length, m"},
    ColumnTitle{"light_time_s", "Light time, s"},
    ColumnTitle{"link", "Link", "1: in range with comm assets up"},
    ColumnTitle{"load_j", "Loads, J", "load_w since the start"},
    ColumnTitle{"load_w", "Loads, W", "all but driving"},
    ColumnTitle{"lon_deg", "Longitude, degrees"},
    ColumnTitle{"loss_j", "Losses, J", "loss_w since the start"},
    ColumnTitle{"loss_w", "Losses, W", "of charging and discharging"},
    ColumnTitle{"name", "Name"},
    ColumnTitle{"panel", "Panel"},
    ColumnTitle{"phase", "Phase"},
    ColumnTitle{"pitch_rad", "Pitch, rad", "nose up"},
    ColumnTitle{"power_w", "Power, W"},
    ColumnTitle{"ready_s", "Its turn came, s", "since the mission's start"},
    ColumnTitle{"reason", "Reason"},
    ColumnTitle{"relay", "Relay", "what joins two ends without a direct link"},
    ColumnTitle{"resource", "Resource"},
    ColumnTitle{"roll_rad", "Roll, rad", "right side down"},
    ColumnTitle{"rover_id", "Rover"},
    ColumnTitle{"sequence", "Sequence"},
    ColumnTitle{"sinkage_m", "Sinkage, m", "mean of the wheels on the ground"},
    ColumnTitle{"slip", "Slip", "mean of the driven wheels on the ground"},
    ColumnTitle{"slip_max", "Slip, greatest"},
    ColumnTitle{"slope_max_rad", "Steepest slope, rad"},
    ColumnTitle{"slope_rad", "Slope, rad", "of the ground under the wheels"},
    ColumnTitle{"solar_available_w", "Solar power to be had, W"},
    ColumnTitle{"solar_j", "Solar energy, J", "solar_w since the start; of events: during it"},
    ColumnTitle{"solar_w", "Solar power, W", "as far as it is used"},
    ColumnTitle{"speed_mps", "Speed, m/s"},
    ColumnTitle{"start_s", "Start, s", "since the mission's start"},
    ColumnTitle{"status", "Status"},
    ColumnTitle{"steepest_lat_deg", "Latitude of the steepest place, degrees"},
    ColumnTitle{"steepest_lon_deg", "Longitude of the steepest place, degrees"},
    ColumnTitle{"sun_fraction", "Sun on panels, 0 to 1", "share of their area that it reaches"},
    ColumnTitle{"time_s", "Time, s", "since the mission's start"},
    ColumnTitle{"to_id", "To"},
    ColumnTitle{"type", "Type"},
    ColumnTitle{"utc", "Time, UTC"},
    ColumnTitle{"value", "Value"},
    ColumnTitle{"visible", "Visible", "1: antenna to antenna; Earth: its disc's centre"},
    ColumnTitle{"visible_fraction", "Visible share of Earth"},
    ColumnTitle{"x_m", "East, m", "of the first rover's start"},
    ColumnTitle{"y_m", "North, m", "of the first rover's start"},
    ColumnTitle{"z_m", "Up, m", "from the first rover's start"},
};

}  // namespace

const ColumnTitle& column_title(std::string_view name) {
  const auto* const found = std::ranges::find(titles, name, &ColumnTitle::name);
  if (found == titles.end()) throw std::out_of_range("no title for " + std::string(name));
  return *found;
}

}  // namespace lsos

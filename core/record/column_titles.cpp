#include "record/column_titles.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "record/layers.h"
#include "record/quantities.h"

namespace lsos {

namespace {

constexpr std::array titles{
    ColumnTitle{"amount", "Amount", "of a resource aboard, in the resource's own unit"},
    ColumnTitle{"angle_rad", "Angle, rad"},
    ColumnTitle{"attempt", "Attempt", "how often the leg had been planned before"},
    ColumnTitle{"azimuth_rad", "Azimuth, rad", "of the panel's face, clockwise from true north"},
    ColumnTitle{"distance_m", "Distance, m", "between the two; of events: driven"},
    ColumnTitle{"duration_s", "Duration, s", "as planned"},
    ColumnTitle{"elevation_rad", "Elevation, rad", "of the panel's face above the horizon"},
    ColumnTitle{"end_s", "End, s", "since the mission's start"},
    ColumnTitle{"end_utc", "End, UTC"},
    ColumnTitle{"energy_j", "Energy, J", "of driving it"},
    ColumnTitle{"energy_used_j", "Energy used, J", "loads, driving and losses"},
    ColumnTitle{"event", "Event", "label of the event that runs"},
    ColumnTitle{"extension_m", "Extension, m"},
    ColumnTitle{"fields", "Fields", "of the note, JSON"},
    ColumnTitle{"from_id", "From"},
    ColumnTitle{"incidence", "Solar incidence, 0 to 1",
                "sun_fraction times the cosine of incidence"},
    ColumnTitle{"joint", "Joint"},
    ColumnTitle{"key", "Key"},
    ColumnTitle{"kind", "Kind",
                "visible or hidden; link: joined directly; relayed: joined by others alone"},
    ColumnTitle{"by", "By", "hidden: ground, or whose bodies stand between; relayed: the relays"},
    ColumnTitle{"label", "Event"},
    ColumnTitle{"lat_deg", "Latitude, degrees"},
    ColumnTitle{"leg", "Leg", "the waypoint that it leads to"},
    ColumnTitle{"length_m", "Length, m"},
    ColumnTitle{"light_time_s", "Light time, s"},
    ColumnTitle{"link", "Link", "1: in range with comm assets up"},
    ColumnTitle{"lon_deg", "Longitude, degrees"},
    ColumnTitle{"name", "Name"},
    ColumnTitle{"panel", "Panel"},
    ColumnTitle{"phase", "Phase"},
    ColumnTitle{"power_w", "Power, W"},
    ColumnTitle{"ready_s", "Its turn came, s", "since the mission's start"},
    ColumnTitle{"reason", "Reason"},
    ColumnTitle{"relay", "Relay", "what joins two ends without a direct link"},
    ColumnTitle{"resource", "Resource"},
    ColumnTitle{"rover_id", "Rover"},
    ColumnTitle{"sequence", "Sequence"},
    ColumnTitle{"slope_max_rad", "Steepest slope, rad"},
    ColumnTitle{"solar_j", "Solar energy, J", "of the panels, during it"},
    ColumnTitle{"start_s", "Start, s", "since the mission's start"},
    ColumnTitle{"status", "Status"},
    ColumnTitle{"steepest_lat_deg", "Latitude of the steepest place, degrees"},
    ColumnTitle{"steepest_lon_deg", "Longitude of the steepest place, degrees"},
    ColumnTitle{"sun_fraction", "Sun on the panel, 0 to 1",
                "share of its area that sunlight reaches"},
    ColumnTitle{"time_s", "Time, s", "since the mission's start"},
    ColumnTitle{"to_id", "To"},
    ColumnTitle{"type", "Type"},
    ColumnTitle{"utc", "Time, UTC"},
    ColumnTitle{"value", "Value"},
    ColumnTitle{"visible", "Visible", "1: antenna to antenna; Earth: its disc's centre"},
    ColumnTitle{"visible_fraction", "Visible share of Earth"},
    ColumnTitle{"x_m", "East, m", "of the site: the first rover's start, or SiteOrigin"},
    ColumnTitle{"y_m", "North, m", "of the site"},
    ColumnTitle{"z_m", "Up, m", "from the ground at the site"},
};

}  // namespace

ColumnTitle column_title(std::string_view layer, std::string_view name) {
  if (layer == layer_name<SampleRow>) {
    const Quantity* quantity = find_quantity(name);
    if (quantity != nullptr) return {name, quantity->title, quantity->meaning};
  }
  const auto* const found = std::ranges::find(titles, name, &ColumnTitle::name);
  if (found == titles.end()) throw std::out_of_range("no title for " + std::string(name));
  return *found;
}

}  // namespace lsos

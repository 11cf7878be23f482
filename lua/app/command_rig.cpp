// `lsos-host rig`: runs the wheel-soil model on its own, so that an engineer can check it.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/quantity.h"
#include "base/rounding.h"
#include "base/units.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/place_options.h"
#include "lua/host/catalog.h"
#include "lua/host/mission_reader.h"
#include "lua/host/soil_file.h"
#include "vehicle/single_wheel.h"

namespace lsos {

namespace {

struct RigOptions {
  std::string soil;  // a name, or a file
  double radius_m = 0, width_m = 0, load_n = 0;
  double grouser_height_m = 0;
  int grouser_count = 0;
  double interface_friction_ratio = Wheel{}.interface_friction_ratio;
  std::optional<double> stiffness_npm;  // absent: the load flattens the wheel by 1 % of its radius
  std::optional<double> carcass_npm;    // absent: a rigid wheel
  double gravity_mps2 = 9.80665;
  std::string slips;         // "0,0.2,0.5"
  bool is_rim_slip = false;  // slips are counted by the rim
  double slip_angle_deg = 0;
  AnswerStyle style = AnswerStyle::by_output;
};

// Deflection of a stiff metal wheel, a share of its radius; matters on ground that it hardly marks.
constexpr double flattening = 0.01;

Soil find_soil(const std::string& name) {
  if (name.ends_with(".lua") || std::filesystem::is_regular_file(name)) return read_soil_file(name);
  return read_catalog("")->load_soil(name, {"--soil", 0});
}

std::vector<double> slips_of(const std::string& text, Faults& faults) {
  std::vector<double> slips;
  for (const std::string& part : option_parts(text)) {
    const auto slip = parse_quantity(part, *find_unit("1"));
    if (slip && std::abs(*slip.value) <= 1) {
      slips.push_back(*slip.value);
    } else {
      faults.error({}, fmt::format("--slip {}: '{}': a number of -1..1 is wanted", text, part));
    }
  }
  return slips;
}

void check_grousers(const RigOptions& options, Faults& faults) {
  const double h_m = options.grouser_height_m;
  const int count = options.grouser_count;
  if (options.radius_m > 0 && !(h_m >= 0 && h_m < options.radius_m)) {
    faults.error({}, fmt::format("--grouser-height {}: must be 0 to the wheel's radius", h_m));
  }
  if (count < 0 || count > 1000) {
    faults.error({}, fmt::format("--grouser-count {}: must be 1..1000", count));
  } else if (h_m > 0 && count == 0) {
    faults.error({}, "--grouser-height: --grouser-count is missing, 1..1000 round the rim");
  } else if (h_m == 0 && count > 0) {
    faults.error({}, "--grouser-count: --grouser-height is missing, more than 0 m");
  }
}

void check_rig(const RigOptions& options, Faults& faults) {
  const auto need = [&](const char* option, double value, bool is_good, const char* allowed) {
    if (!is_good) faults.error({}, fmt::format("{} {}: must be {}", option, value, allowed));
  };
  const auto above = [](double value) { return std::isfinite(value) && value > 0; };
  const auto within = [](double value, double most) { return value > 0 && value <= most; };
  // The ranges are those of wheels in rover scripts.
  need("--radius", options.radius_m, within(options.radius_m, 10), "above 0, at most 10 m");
  need("--width", options.width_m, within(options.width_m, 10), "above 0, at most 10 m");
  need("--load", options.load_n, above(options.load_n), "above 0 N");
  if (options.stiffness_npm) {
    need("--stiffness", *options.stiffness_npm,
         *options.stiffness_npm * options.radius_m >= options.load_n &&
             std::isfinite(*options.stiffness_npm),
         "so great that the load does not flatten the wheel by its radius");
  }
  if (options.carcass_npm) {
    need("--carcass", *options.carcass_npm,
         *options.carcass_npm * options.radius_m >= 2 * options.load_n &&
             std::isfinite(*options.carcass_npm),
         "so great that the load flattens the wheel by half its radius at most");
  }
  need("--gravity", options.gravity_mps2, within(options.gravity_mps2, 1000),
       "above 0, at most 1000 m/s2");
  check_grousers(options, faults);
  need("--interface-friction", options.interface_friction_ratio,
       options.interface_friction_ratio > 0 && options.interface_friction_ratio <= 1,
       "above 0, at most 1");
  need("--slip-angle", options.slip_angle_deg, std::abs(options.slip_angle_deg) <= 90,
       "-90..90 deg");
}

int rig_command(const RigOptions& options) {
  Faults faults;
  check_rig(options, faults);
  const std::vector<double> slips = slips_of(options.slips, faults);
  faults.throw_if_errors();
  const Soil soil = find_soil(options.soil);
  Wheel wheel;
  wheel.radius_m = options.radius_m;
  wheel.width_m = options.width_m;
  wheel.grouser_height_m = options.grouser_height_m;
  wheel.grouser_count = options.grouser_count;
  wheel.interface_friction_ratio = options.interface_friction_ratio;
  wheel.normal_stiffness_npm =
      options.stiffness_npm.value_or(options.load_n / (flattening * options.radius_m));
  if (options.carcass_npm) wheel.carcass_stiffness_npm = *options.carcass_npm;
  if (const std::string fault = soil_fault(soil, wheel, 0, options.gravity_mps2); !fault.empty()) {
    throw InputError({options.soil, 0}, fault);
  }
  const std::string overload = soil_fault(soil, wheel, options.load_n, options.gravity_mps2);
  if (!overload.empty()) print_message("{}: warning: {}\n", options.soil, overload);
  const WheelSoil wheel_soil(soil, wheel, options.gravity_mps2);
  AnswerRow points = AnswerRow::array();
  const double rolling_radius_m = wheel_soil.rolling_radius_m(options.load_n);
  for (const double asked : slips) {
    const double slip =
        options.is_rim_slip ? slip_by(rolling_radius_m, asked, options.radius_m) : asked;
    const SingleWheelPoint point =
        single_wheel(wheel_soil, options.load_n, slip, radians(options.slip_angle_deg));
    if (point.drawbar_pull_n > pull_share_max * options.load_n) {
      print_message(
          "{}: warning: at slip {:.3g} the wheel pulls {:.2f} of its load; no measured wheel has "
          "pulled more than {}, so the model is beyond what it was compared with\n",
          options.soil, asked, point.drawbar_pull_n / options.load_n, pull_share_max);
    }
    points.push_back({{"slip", asked},
                      {"slip_angle_deg", options.slip_angle_deg},
                      {"load_n", options.load_n},
                      {"drawbar_pull_n", computed(point.drawbar_pull_n)},
                      {"side_force_n", computed(point.side_force_n)},
                      {"torque_n_m", computed(point.torque_n_m)},
                      {"sinkage_m", computed(point.sinkage_m)},
                      {"traction_limit_n", computed(point.traction_limit_n)},
                      {"rolling_radius_m", computed(rolling_radius_m)}});
  }
  print_answer(points, options.style);
  return 0;
}

}  // namespace

std::function<int()> prepare_rig(CommandOptions& command) {
  const auto options = std::make_shared<RigOptions>();
  command.add_option("--soil", options->soil, "A soil by name, or a Lua file").required();
  command.add_option("--radius", options->radius_m, "Of the wheel's rim, m").required();
  command.add_option("--width", options->width_m, "m").required();
  command.add_option("--load", options->load_n, "On the wheel, N").required();
  command.add_option("--slip", options->slips, "-1..1, one or several: 0,0.2,0.5").required();
  command.add_flag(
      "--rim-slip", options->is_rim_slip,
      "Count slip by the rim, as some rigs do; else by the rolling radius, at which the "
      "wheel turns without torque");
  command.add_option("--slip-angle", options->slip_angle_deg,
                     "Of the travel from the heading, deg, to the left positive");
  command.add_option("--grouser-height", options->grouser_height_m, "m");
  command.add_option("--grouser-count", options->grouser_count, "Round the whole rim");
  command.add_option(
      "--interface-friction", options->interface_friction_ratio,
      "Friction of soil on the rim over that in the soil, above 0, at most 1 (0.65)");
  command.add_option("--stiffness", options->stiffness_npm,
                     "Of the wheel, N/m (the load flattens it by 1 % of its radius)");
  command.add_option("--carcass", options->carcass_npm,
                     "Load that flattens a soft wheel by a metre, N/m (a rigid wheel)");
  command.add_option("--gravity", options->gravity_mps2, "m/s2 (9.80665)");
  add_style(command, options->style);
  return [options] { return rig_command(*options); };
}

}  // namespace lsos

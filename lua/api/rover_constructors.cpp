// lsos.rover, its body and its configurations.
#include "lua/api/rover_constructors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/sim_time.h"
#include "lua/api/antenna_constructor.h"
#include "lua/api/constructors.h"
#include "lua/api/power_constructors.h"
#include "mission/model/rover_model.h"

namespace lsos {

namespace {

struct Chassis {
  Inertia inertia;
  Vec3 center_of_mass_m = Vec3::Zero();
  Vec3 size_m = Vec3::Zero();
  double clearance_m = 0;
};

bool is_positive(const Vec3& v) { return v.minCoeff() > 0; }

// Whether a principal moment is at most the sum of the other two. A flat disc's moment about its
// axle equals that sum, hence the tolerance.
bool is_at_most_the_others(double moment_kgm2, const Vec3& all_kgm2) {
  constexpr double slack = 1e-9;
  return moment_kgm2 <= (all_kgm2.sum() - moment_kgm2) * (1 + slack);
}

// Principal moments of a box with evenly distributed mass.
Vec3 box_moments_kgm2(double mass_kg, const Vec3& size_m) {
  const Vec3 squares = size_m.cwiseProduct(size_m);
  return mass_kg / 12 *
         Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
}

void read_chassis(TableReader& t, Chassis& chassis) {
  t.number(required, "mass_kg", chassis.inertia.mass_kg, positive,
           "With load, without suspension and wheels.");
  t.vec3(required, "size_m", chassis.size_m, "Length, width, height of its box.");
  t.number(required, "clearance_m", chassis.clearance_m, not_negative,
           "From the ground to the box's underside at rest.");
  t.vec3(required, "center_of_mass_m", chassis.center_of_mass_m,
         "Forward, left, up from the ground centre of the wheelbase at rest.");
  std::optional<Vec3> moments_kgm2;
  read_moments(
      t, MomentsOf::body, moments_kgm2,
      "Principal moments about its centre of mass (default: of the box, mass spread evenly).");
  if (chassis.size_m != Vec3::Zero() && !is_positive(chassis.size_m)) {
    t.fault("size_m: all three must be more than 0 m");
  }
  chassis.inertia.moments_kgm2 =
      moments_kgm2.value_or(box_moments_kgm2(chassis.inertia.mass_kg, chassis.size_m));
}

// Reads joints = { rocker_left = 0.2 }.
void read_joints(TableReader& t, std::map<std::string, double>& joints) {
  if (!t.take(optional, "joints", "table of numbers, m or rad",
              "Where joints stand at the start, by name; the others at 0."))
    return;
  lua_State* L = t.L();
  if (lua_istable(L, -1)) {
    lua_pushnil(L);
    while (lua_next(L, -2) != 0) {
      if (lua_type(L, -2) != LUA_TSTRING || lua_type(L, -1) != LUA_TNUMBER) {
        t.fault("joints: NAME = number is wanted throughout, as in { rocker_left = 0.2 }");
      } else if (!std::isfinite(lua_tonumber(L, -1))) {
        t.fault(fmt::format("joints: {} must be finite", lua_tostring(L, -2)));
      } else {
        joints[lua_tostring(L, -2)] = lua_tonumber(L, -1);
      }
      lua_pop(L, 1);
    }
  } else if (!lua_isnil(L, -1)) {
    t.fault(fmt::format("joints: a table is wanted, found {}", describe(L, -1)));
  }
  lua_pop(L, 1);
}

void read_configuration(TableReader& t, RoverConfiguration& configuration) {
  t.text(required, "name", configuration.name, "What a plan's RoverConfig says.");
  t.text(required, "doc", configuration.doc, "One sentence that a mission planner understands.");
  read_joints(t, configuration.joints);
  t.number(optional, "height_m", configuration.height_m, positive,
           "On limbs: of the chassis' underside over the ground, with its wheels where they stand "
           "(default: as `joints` say).");
  t.boolean(optional, "is_level", configuration.is_level,
            "On limbs with posture control: whether it keeps the chassis level, else parallel to "
            "the ground (default true).");
  t.texts(optional, "free_wheels", configuration.free_wheels,
          "Wheels that turn without motor and brake, by name.");
  t.texts(optional, "locked_wheels", configuration.locked_wheels,
          "Wheels that do not turn at all, by name.");
  t.number(optional, "payload_mass_kg", configuration.payload_mass_kg, any_number,
           "On the chassis besides its own mass, as a point; negative takes load off (default 0).");
  t.vec3(optional, "payload_position_m", configuration.p_BP_m,
         "Of its centre of mass: forward, left, up as for the chassis (default 0, 0, 0).");
  t.integer(optional, "crew", configuration.crew, {0, 100},
            "Aboard in this configuration (default: as many as the rover carries).");
}

// Reads one of four kinds of suspension.
void read_suspension(TableReader& t, Suspension& suspension) {
  constexpr const char* kinds = "lsos.wishbone, lsos.rocker_bogie, lsos.skid_steer or lsos.legged";
  if (!t.take(required, "suspension", kinds, "Springs or rockers, steering and wheels.")) return;
  const ConstructedValue* made = to_constructed(t.L(), -1);
  if (made != nullptr && made->kind == "wishbone") {
    suspension = std::any_cast<Wishbone>(made->value);
  } else if (made != nullptr && made->kind == "rocker_bogie") {
    suspension = std::any_cast<RockerBogie>(made->value);
  } else if (made != nullptr && made->kind == "skid_steer") {
    suspension = std::any_cast<SkidSteer>(made->value);
  } else if (made != nullptr && made->kind == "legged") {
    suspension = std::any_cast<Legged>(made->value);
  } else if (!lua_isnil(t.L(), -1)) {
    t.fault(fmt::format("suspension: {} is wanted, found {}", kinds, describe(t.L(), -1)));
  }
  lua_pop(t.L(), 1);
}

// Reads the physics step, which must divide the exchange period exactly.
void read_step(TableReader& t, VehicleConfig& vehicle) {
  double step_s = seconds(vehicle.step);
  t.number(required, "step_s", step_s, {1e-5, seconds(exchange_period)},
           "Physics step; divides 0.1 s.");
  const SimTime step = from_seconds(step_s);
  if (std::abs(seconds(step) - step_s) > 1e-12 || exchange_period % step != SimTime::zero()) {
    t.fault(fmt::format("step_s = {}: must divide the exchange period of {} s, as 0.005 does",
                        step_s, seconds(exchange_period)));
  } else {
    vehicle.step = step;
  }
}

void read_ground_limits(TableReader& t, GroundLimits& limits) {
  constexpr double right_angle_rad = 1.5707963267948966;
  t.number(optional, "slope_max_rad", limits.slope_max_rad, {0, right_angle_rad, true},
           "Steepest under its wheels, in any direction (default: 0.6 of what tips it over).");
  t.number(optional, "slip_max", limits.slip_max, {0, 1, true},
           "Of its wheels on a steady climb (default 0.6).");
  t.number(optional, "clearance_min_m", limits.clearance_min_m, not_negative,
           "Between chassis and ground (default: 0.3 of it at rest).");
  t.number(optional, "unevenness_max_m", limits.unevenness_max_m, positive,
           "Of the ground at a wheel from the plane under the others (default: a wheel's radius).");
}

void read_rover(TableReader& t, RoverModel& model) {
  RoverSpec& spec = model.spec;
  std::string name;
  Chassis chassis;
  VehicleConfig& vehicle = spec.vehicle;
  t.api_version();
  t.text(optional, "name", name, "The file's name, for readers; nothing else is allowed.");
  t.text(required, "doc", spec.doc, "One sentence that a mission planner understands.");
  t.made(required, "chassis", "chassis", chassis, "Body and load.");
  read_suspension(t, spec.suspension);
  t.list(optional, "configurations", "configuration", spec.configurations,
         "What a plan's RoverConfig may name.");
  read_step(t, vehicle);
  t.number(required, "cruise_speed_mps", vehicle.cruise_speed_mps, positive,
           "When an event gives no speed.");
  t.number(required, "speed_max_mps", vehicle.speed_max_mps, positive, "On level ground.");
  t.number(required, "acceleration_mps2", vehicle.acceleration_mps2, positive,
           "Speeding up and slowing down along a path.");
  t.boolean(optional, "can_turn_on_spot", vehicle.can_turn_on_spot, "Default false.");
  t.boolean(optional, "can_crab", vehicle.can_crab,
            "Drives in any direction without turning (default false).");
  t.number(optional, "turning_radius_min_m", vehicle.turning_radius_min_m, not_negative,
           "While driving (default 5).");
  t.integer(optional, "crew", model.crew, {0, 100}, "How many it carries, whom EVA sends out.");
  t.made(optional, "limits", "limits", model.limits, "Ground that planned routes keep off.");
  t.number(optional, "drive_calibration", vehicle.drive_calibration, positive,
           "Electrical drive power is multiplied by this to match measurements (default 1).");
  t.text(optional, "drive_calibration_source", vehicle.drive_calibration_source,
         "The measurements; required unless drive_calibration is 1.");
  read_power(t, model.power);
  read_shapes(t, model.shapes);
  read_antennas(t, model.antennas);
  t.texts(optional, "assumptions", vehicle.assumptions,
          "Sentences about numbers that have no source; they go into summary.json.");
  if (vehicle.cruise_speed_mps > vehicle.speed_max_mps) {
    t.fault("cruise_speed_mps is above speed_max_mps");
  }
  if (!vehicle.can_turn_on_spot && vehicle.turning_radius_min_m == 0) {
    t.fault("turning_radius_min_m = 0: must be more than 0 m unless can_turn_on_spot = true");
  }
  if (t.L() == nullptr) return;
  spec.name = script_name(t.place().file);
  spec.place = t.place();
  vehicle.type = spec.name;
  vehicle.chassis = chassis.inertia;
  vehicle.p_BC_m = chassis.center_of_mass_m;
  vehicle.chassis_size_m = chassis.size_m;
  vehicle.chassis_clearance_m = chassis.clearance_m;
  if (!name.empty() && name != spec.name) {
    t.fault(fmt::format("name = '{}': must be '{}', the name of the file", name, spec.name));
  }
}

}  // namespace

void read_moments(TableReader& t, MomentsOf of, std::optional<Vec3>& moments_kgm2,
                  const char* doc) {
  t.vec3(optional, "inertia_kgm2", moments_kgm2, doc);
  if (!moments_kgm2) return;
  const Vec3& m = *moments_kgm2;
  if (!is_positive(m)) {
    t.fault("inertia_kgm2: all three must be more than 0 kg m2");
    return;
  }
  const bool is_wheel = of == MomentsOf::wheel;
  const bool is_axle_right = is_wheel || is_at_most_the_others(m.y(), m);
  if (is_at_most_the_others(m.x(), m) && is_axle_right && is_at_most_the_others(m.z(), m)) return;
  t.fault(
      fmt::format("inertia_kgm2 = ({:.6g}, {:.6g}, {:.6g}): no {} has these: {} must be at most "
                  "the sum of the other two",
                  m.x(), m.y(), m.z(), is_wheel ? "wheel" : "body",
                  is_wheel ? "the first and the last moment each" : "each moment"));
}

std::vector<Constructor> rover_constructors() {
  std::vector<Constructor> all{
      constructor<RoverModel, read_rover>(rover_kind, "What a script in rovers/ returns."),
      constructor<Chassis, read_chassis>("chassis", "The body that the suspension carries."),
      constructor<GroundLimits, read_ground_limits>("limits",
                                                    "Ground that planned routes keep off."),
      constructor<RoverConfiguration, read_configuration>(
          "configuration", "How a rover may stand and be loaded at the start.")};
  for (auto&& more : {suspension_constructors(), power_constructors(), antenna_constructors(),
                      asset_constructors()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace lsos

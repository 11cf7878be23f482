#include "planet/diffuse_light.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// The layer after the delta scaling: the share g^2 of the scattered light that goes nearly straight
// on counts as not scattered. `rate` is the exponent with which diffuse light decays.
struct ScaledLayer {
  double depth, albedo;
  double gamma1, gamma2;
  double gamma3_slope;  // of gamma3 = (2 - slope mu) / 4
  double rate;
};

// Coefficients of the Eddington approximation (Meador and Weaver 1980, table 1):
//   gamma1 = (7 - w (4 + 3 g)) / 4,  gamma2 = -(1 - w (4 - 3 g)) / 4,  gamma3 = (2 - 3 g mu) / 4
// with w the single-scattering albedo and g the asymmetry of the scaled layer.
ScaledLayer scaled(const Dust& dust, double optical_depth) {
  // The solution has no value for dust that absorbs nothing, and its limit is smooth.
  const double albedo = std::min(dust.single_scattering_albedo, 1 - 1e-9);
  const double forward = dust.asymmetry * dust.asymmetry;
  const double w = albedo * (1 - forward) / (1 - albedo * forward);
  const double g = dust.asymmetry / (1 + dust.asymmetry);
  ScaledLayer layer{};
  layer.depth = (1 - albedo * forward) * optical_depth;
  layer.albedo = w;
  layer.gamma1 = (7 - w * (4 + 3 * g)) / 4;
  layer.gamma2 = -(1 - w * (4 - 3 * g)) / 4;
  layer.gamma3_slope = 3 * g;
  layer.rate = std::sqrt(layer.gamma1 * layer.gamma1 - layer.gamma2 * layer.gamma2);
  return layer;
}

struct LayerShares {
  double reflected, transmitted;
};

// The layer lit evenly from one side (Meador and Weaver 1980, equations 14 and 15 without a beam).
LayerShares diffuse_shares(const ScaledLayer& layer) {
  const double k = layer.rate;
  const double once = std::exp(-k * layer.depth), twice = once * once;
  const double whole = (k + layer.gamma1) + (k - layer.gamma1) * twice;
  return {layer.gamma2 * (1 - twice) / whole, 2 * k * once / whole};
}

// The layer lit by a beam: what it scatters up and down (Meador and Weaver 1980, equations 14 and
// 15, both sides multiplied by exp(-k depth) so that deep layers do not overflow).
LayerShares beam_shares(const ScaledLayer& layer, double sine, double beam) {
  const double k = layer.rate;
  // Both the numerator and the denominator vanish where k sine = 1.
  double mu = sine;
  if (std::abs(1 - k * mu) < 1e-6) mu = (1 - 1e-6) / k;
  const double gamma3 = (2 - layer.gamma3_slope * mu) / 4, gamma4 = 1 - gamma3;
  const double alpha1 = layer.gamma1 * gamma4 + layer.gamma2 * gamma3;
  const double alpha2 = layer.gamma1 * gamma3 + layer.gamma2 * gamma4;
  const double once = std::exp(-k * layer.depth), twice = once * once;
  const double whole =
      (1 - k * k * mu * mu) * ((k + layer.gamma1) + (k - layer.gamma1) * twice) / layer.albedo;
  const double up = (1 - k * mu) * (alpha2 + k * gamma3) -
                    (1 + k * mu) * (alpha2 - k * gamma3) * twice -
                    2 * k * (gamma3 - alpha2 * mu) * beam * once;
  const double down =
      2 * k * (gamma4 + alpha1 * mu) * once -
      beam * ((1 + k * mu) * (alpha1 + k * gamma4) - (1 - k * mu) * (alpha1 - k * gamma4) * twice);
  return {up / whole, down / whole};
}

}  // namespace

LayerLight dusty_light(const Dust& dust, double optical_depth, double sine, double ground_albedo) {
  if (optical_depth <= 0) return {.escaped = ground_albedo};
  const ScaledLayer layer = scaled(dust, optical_depth);
  const double beam = std::exp(-layer.depth / sine);
  LayerLight light;
  light.direct = std::exp(-optical_depth / sine);
  light.aureole = beam - light.direct;
  if (layer.albedo <= 0) {
    light.escaped = ground_albedo * light.direct * std::exp(-layer.gamma1 * layer.depth);
    return light;
  }
  const LayerShares lit = beam_shares(layer, sine, beam), diffuse = diffuse_shares(layer);
  // Light goes to and fro between ground and layer: 1 + A R + (A R)^2 + ...
  const double down = (beam + lit.transmitted) / (1 - ground_albedo * diffuse.reflected);
  light.sky = std::max(0.0, down - beam);
  light.escaped = lit.reflected + ground_albedo * down * diffuse.transmitted;
  return light;
}

double clear_sky_diffuse_share(double direct_share) {
  return std::max(0.0, 0.271 - 0.294 * direct_share);
}

}  // namespace lsos

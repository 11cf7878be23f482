// Light that reaches level ground by way of the air: what dust or clear air scatters downward.
#pragma once

namespace lsos {

// Optical properties of dust, averaged over the light of the Sun.
struct Dust {
  double single_scattering_albedo = 0;  // share of the light taken from a ray that is scattered
  double asymmetry = 0;                 // mean cosine of the scattering angle
};

// Dust of Mars as seen by the Viking landers (Pollack et al. 1979). Pollack's flux table, from
// which arrays for Mars are sized (Appelbaum and Flood 1990), was computed for it. Later work finds
// brighter dust (0.92, Clancy and Lee 1991; 0.94, Wolff et al. 2009), which would raise the light
// on the ground by up to 6 % at optical depth 1: this is the careful choice.
inline constexpr Dust mars_dust{0.86, 0.79};

// Light through a level layer over ground that reflects, as shares of what falls on level ground
// without it. Down to the ground come direct + aureole + sky.
struct LayerLight {
  double direct = 1;   // of the Sun's disc, not scattered
  double aureole = 0;  // scattered forward, so that it comes from around the Sun
  double sky = 0;      // scattered by more, taken to come evenly from the whole sky
  double escaped = 0;  // upward, out of the top

  double down() const { return direct + aureole + sky; }
};

// Delta-Eddington two-stream solution (Joseph, Wiscombe and Weinman 1976), with the ground's
// reflections between ground and layer summed. `sine`: of the Sun's elevation, above 0.
LayerLight dusty_light(const Dust& dust, double optical_depth, double sine, double ground_albedo);

// Diffuse light of a clear sky on level ground, as a share of what falls on it without air, from
// the share of direct light that comes through (Liu and Jordan 1960).
double clear_sky_diffuse_share(double direct_share);

}  // namespace lsos

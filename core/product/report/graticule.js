// Longitude and latitude of the map, whose plane is tangent to the body at the site.
const site = (() => {
  const {lon_deg, lat_deg, height_m, equatorial_radius_m, flattening} = page.site;
  const lon = (lon_deg * Math.PI) / 180, lat = (lat_deg * Math.PI) / 180;
  // Ground at the site's height is nearly an ellipsoid whose semi-axes are larger by that height.
  const a = equatorial_radius_m + height_m, b = equatorial_radius_m * (1 - flattening) + height_m;
  const up = [Math.cos(lat) * Math.cos(lon), Math.cos(lat) * Math.sin(lon), Math.sin(lat)];
  const east = [-Math.sin(lon), Math.cos(lon), 0];
  const north = [-Math.sin(lat) * Math.cos(lon), -Math.sin(lat) * Math.sin(lon), Math.cos(lat)];
  const fixed = (lonRad, latRad) => {
    const across = (a * a) / Math.hypot(a * Math.cos(latRad), b * Math.sin(latRad));
    const out = across * Math.cos(latRad);
    return [out * Math.cos(lonRad), out * Math.sin(lonRad), ((b * b) / (a * a)) * across * Math.sin(latRad)];
  };
  return {a, b, up, east, north, fixed, origin: fixed(lon, lat)};
})();
const dot3 = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];

// Degrees [east, north] of a point of the map, on ground at the site's height; null where the
// vertical through the point misses the body.
function degreesOf(x, y) {
  const ratio = (site.a / site.b) ** 2;
  const from = [0, 1, 2].map(k => site.origin[k] + x * site.east[k] + y * site.north[k]);
  const times = (u, v) => u[0] * v[0] + u[1] * v[1] + ratio * u[2] * v[2];
  // Solves for t at which from + t up meets the ellipsoid: the root near 0, in a form without
  // cancellation.
  const half = times(from, site.up), rest = times(from, from) - site.a ** 2, square = times(site.up, site.up);
  const under = half * half - square * rest;
  if (under < 0) return null;
  const t = -rest / (half + Math.sqrt(under));
  const p = from.map((value, k) => value + t * site.up[k]);
  return [Math.atan2(p[1], p[0]), Math.atan2(ratio * p[2], Math.hypot(p[0], p[1]))].map(rad => (rad * 180) / Math.PI);
}
// The point of the map at a longitude and latitude.
function pointOf(lonDeg, latDeg) {
  const p = site.fixed((lonDeg * Math.PI) / 180, (latDeg * Math.PI) / 180).map((value, k) => value - site.origin[k]);
  return [dot3(p, site.east), dot3(p, site.north)];
}

const metresPerDegree = (site.a * Math.PI) / 180;
const sideText = (degrees, places, plus, minus) => `${Math.abs(degrees).toFixed(places)}° ${degrees < 0 ? minus : plus}`;
// Text of the place under the cursor: degrees to about half a metre, and distances from the start.
function placeText(x, y) {
  const side = (value, plus, minus) => `${distanceText(Math.abs(value))} ${value < 0 ? minus : plus}`;
  const away = `${side(x, 'east', 'west')}, ${side(y, 'north', 'south')} of the start`;
  const place = degreesOf(x, y);
  if (!place) return away;
  return `${sideText(place[1], 5, 'N', 'S')}, ${sideText(place[0], 5, 'E', 'W')}; ${away}`;
}

const degreeSteps = [1, 2, 5].flatMap(digit => [-5, -4, -3, -2, -1, 0].map(power => digit * 10 ** power))
  .concat([15, 30, 45, 90]).sort((a, b) => a - b);
// Meridians and parallels over a part of the map, about four of each: {points, text, isMeridian}.
function graticule(box) {
  const seen = [];
  for (let i = 0; i <= 8; ++i) {
    for (let j = 0; j <= 8; ++j) {
      const place = degreesOf(box.left + ((box.right - box.left) * i) / 8, box.bottom + ((box.top - box.bottom) * j) / 8);
      if (!place) return [];
      seen.push(place);
    }
  }
  // Longitudes are counted from that of the centre, so that there is no edge at 180.
  const middle = seen[40][0];
  const lons = seen.map(([lon]) => middle + (((lon - middle + 540) % 360) - 180)), lats = seen.map(place => place[1]);
  const hasPole = sign => {
    const [x, y] = pointOf(0, sign * 90);
    return sign * seen[40][1] > 0 && x > box.left && x < box.right && y > box.bottom && y < box.top;
  };
  const isPolar = hasPole(1) || hasPole(-1);
  const range = values => [Math.min(...values), Math.max(...values)];
  const [west, east] = isPolar ? [middle - 180, middle + 180] : range(lons);
  const [south, north] = [hasPole(-1) ? -90 : Math.min(...lats), hasPole(1) ? 90 : Math.max(...lats)];
  const stepOf = span => degreeSteps.find(step => step >= span / 5) || 90;
  const placesOf = step => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const evens = (from, to, step) => {
    const list = [];
    for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) list.push(k * step);
    return list;
  };
  const along = (from, to, point) => Array.from({length: 33}, (_, k) => point(from + ((to - from) * k) / 32));
  const lonStep = stepOf(east - west), latStep = stepOf(north - south);
  const turned = lon => ((((lon + 180) % 360) + 360) % 360) - 180;
  return [
    ...evens(west, isPolar ? east - lonStep / 2 : east, lonStep).map(lon => ({
      points: along(Math.max(south, -89.999), Math.min(north, 89.999), lat => pointOf(lon, lat)),
      text: sideText(turned(lon), placesOf(lonStep), 'E', 'W'), isMeridian: true,
    })),
    ...evens(south, north, latStep).map(lat => ({
      points: along(west, east, lon => pointOf(lon, lat)), text: sideText(lat, placesOf(latStep), 'N', 'S'), isMeridian: false,
    })),
  ];
}

// The other coordinate where a line on the screen crosses x = at (axis 0) or y = at (axis 1); or null.
function crossing(places, axis, at) {
  for (let k = 1; k < places.length; ++k) {
    const a = places[k - 1], b = places[k];
    if ((a[axis] - at) * (b[axis] - at) > 0 || a[axis] === b[axis]) continue;
    const share = (at - a[axis]) / (b[axis] - a[axis]);
    return a[1 - axis] + share * (b[1 - axis] - a[1 - axis]);
  }
  return null;
}

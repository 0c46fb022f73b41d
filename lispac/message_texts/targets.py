"""Texts of messages about targets and the search for them."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- planes and spheres through points ---------------------------------------------------------
    "target.plane_few_points": N_(
        "A plane needs at least three points, but only {count:n} are given."
    ),
    "target.plane_not_finite": N_(
        "A plane cannot be fitted, because some points have NaN or infinite coordinates."
    ),
    "target.plane_on_line": N_("The points lie on one straight line and do not determine a plane."),
    "target.sphere_radius": N_(
        "A sphere cannot have a radius of {radius:m} m. Give a radius above zero."
    ),
    "target.sphere_few_points": N_(
        "A sphere needs at least four points, but only {count:n} are given."
    ),
    "target.sphere_not_finite": N_(
        "A sphere cannot be fitted, because some points have NaN or infinite coordinates."
    ),
    "target.sphere_in_plane": N_("The points lie in one plane and do not determine a sphere."),
    "target.sphere_little_curved": N_(
        "The curvature of the points is too small, compared with their noise, to determine the "
        "radius of a sphere. Give the radius, or select a larger part of the surface."
    ),
    "target.sphere_small_part": N_(
        "The points cover too small a part of a sphere of this radius to determine its centre. "
        "Select a larger part of the surface."
    ),
    "target.sphere_side": N_(
        "The points are too flat to determine on which side of them the centre of the sphere lies. "
        "Select a larger part of the surface."
    ),
    # -- measuring and display ---------------------------------------------------------------------
    "target.angle_same_points": N_(
        "Two of the three points are identical. Choose three different points to measure an angle."
    ),
    "target.section_vertical": N_(
        "The two points lie vertically above each other, so the cross-section has no direction. "
        "Choose points that are apart horizontally."
    ),
    "target.point_spacing": N_("The point spacing must be a finite number, in metres. Correct it."),
    # -- settings of the search --------------------------------------------------------------------
    "finder.setting": N_("The setting {name} of the plane search cannot be {value}. Correct it."),
    "finder.expected_size": N_("The expected width and height must be above zero. Correct them."),
    "finder.expected_tilt": N_("The expected tilt must be from 0 to 90°. Correct it."),
    "finder.radii": N_(
        "The radius range from {least:m} to {most:m} m of the sphere search is not valid. Give two "
        "values above zero, the smaller one first."
    ),
    "finder.seed": N_("The seed must be three finite numbers: north, west and up, in metres."),
    # -- search in one line ------------------------------------------------------------------------
    "finder.seed_position": N_("the point (east {east:m.2} m; north {north:m.2} m; up {up:m.2} m)"),
    "finder.predicted_position": N_("the position predicted for the target on this line"),
    "finder.few_points": Plural(
        "Only {count:n} point lies within {radius:m} m of {place}, but a target needs at least "
        "{needed:n}. Choose another point, or increase the search radius.",
        "Only {count:n} points lie within {radius:m} m of {place}, but a target needs at least "
        "{needed:n}. Choose another point, or increase the search radius.",
    ),
    "finder.no_points": N_(
        "There are no points within {radius:m} m of {place}; the nearest point is {distance:m.2} m "
        "away. Choose another point, or increase the search radius."
    ),
    "finder.no_points_near": N_(
        "There are no points within {radius:m} m of {place}. Choose another point, or increase the "
        "search radius."
    ),
    "finder.no_plane": N_("No plane fits the points around {place} within {threshold:mm} mm."),
    "finder.plane_few_points": Plural(
        "The plane around {place} has only {count:n} point within {threshold:mm} mm, but a "
        "target needs at least {needed:n}. Choose a place where the points are denser, or increase "
        "the threshold of the search.",
        "The plane around {place} has only {count:n} points within {threshold:mm} mm, but a "
        "target needs at least {needed:n}. Choose a place where the points are denser, or increase "
        "the threshold of the search.",
    ),
    "finder.other_tilt": N_("The plane around {place} does not have the expected orientation."),
    "finder.sphere_of_radius": N_("sphere of radius {radius:m.3} m"),
    "finder.sphere_of_radii": N_("sphere with a radius from {least:m.3} to {most:m.3} m"),
    "finder.sphere_few_nearby": Plural(
        "Only {count:n} point lies within {radius:m} m of {place}, too few for a {sphere} (at "
        "least {needed:n} are needed). Choose a point on the sphere.",
        "Only {count:n} points lie within {radius:m} m of {place}, too few for a {sphere} (at "
        "least {needed:n} are needed). Choose a point on the sphere.",
    ),
    "finder.no_sphere": N_("No {sphere} fits the points around {place} within {threshold:mm} mm."),
    "finder.sphere_few_points": Plural(
        "The sphere around {place} has only {count:n} point within {threshold:mm} mm, but a "
        "target needs at least {needed:n}. Choose a place where the points are denser, or increase "
        "the threshold of the search.",
        "The sphere around {place} has only {count:n} points within {threshold:mm} mm, but a "
        "target needs at least {needed:n}. Choose a place where the points are denser, or increase "
        "the threshold of the search.",
    ),
    "finder.sphere_other_radius": N_(
        "The surface around {place} is curved with a radius of {radius:m.3} m, but a {sphere} is "
        "searched for."
    ),
    "finder.sphere_far": N_(
        "The nearest sphere is {distance:m.2} m from {place}. Choose a point on the sphere."
    ),
    "finder.sphere_continues": Plural(
        "A {sphere} around {place} fits {count:n} point, but {beside:n} points beside it belong "
        "to the same surface. The surface is not a sphere, has another radius, or its noise "
        "exceeds the threshold.",
        "A {sphere} around {place} fits {count:n} points, but {beside:n} points beside it belong "
        "to the same surface. The surface is not a sphere, has another radius, or its noise "
        "exceeds the threshold.",
    ),
    "finder.sphere_small_part": N_(
        "The points around {place} cover only {share:percent.0} % of the surface of a sphere, but "
        "a target needs at least {needed:percent.0} %."
    ),
    "finder.sphere_flat": N_("The surface around {place} is flat, not a sphere."),
    # -- search in all lines -----------------------------------------------------------------------
    "finder.unknown_line": N_("There is no line named {line}. Check the name."),
    "finder.no_line_for_plane": N_(
        "There is no line in which to search for a plane. Import a line first."
    ),
    "finder.no_line_for_sphere": N_(
        "There is no line in which to search for a sphere. Import a line first."
    ),
    "finder.no_plane_in_lines": N_(
        "No plane was found at the chosen point on any line. On the nearest line, {line}: {reason}"
    ),
    "finder.no_sphere_in_lines": N_(
        "No sphere was found at the chosen point on any line. On the nearest line, {line}: {reason}"
    ),
    "finder.line_few_points": Plural(
        "There is only {count:n} point within {radius:m} m of the chosen point (search radius plus "
        "possible shift of the line).",
        "There are only {count:n} points within {radius:m} m of the chosen point (search radius "
        "plus possible shift of the line).",
    ),
    "finder.line_no_points": N_(
        "There are no points within {radius:m} m of the chosen point (search radius plus possible "
        "shift of the line)."
    ),
    "finder.not_alike": N_(
        "The surfaces found there differ from the target in shape or surroundings."
    ),
    "finder.too_few_where_expected": N_(
        "The line has too few points at the predicted position of the target."
    ),
    "finder.small_part": N_(
        "The plane found covers only {share:percent.0} % of the outline of the target."
    ),
    "finder.too_large": N_(
        "The plane found is {ratio:x.1} times as large as the target, so it is another surface."
    ),
    "finder.crossing": N_("The points found belong to a surface that crosses the target."),
    "finder.two_planes": N_(
        "Two planes {distance:m.2} m apart resemble the target equally well. Pick the target "
        "on this line separately."
    ),
    "finder.two_spheres": N_(
        "Two spheres {distance:m.2} m apart resemble the target equally well. Pick the target "
        "on this line separately."
    ),
    "agreement.no_overlap": N_(
        "Only {share:percent.0} % of the plane found lies within the outline of the target on the "
        "other lines. It is another surface."
    ),
    "agreement.sphere_apart": N_(
        "The sphere found is {distance:m.2|limit} m from the target on the other lines, farther "
        "than the limit of {limit:m.2|distance} m. It is another sphere."
    ),
    "agreement.other_plane": N_(
        "The plane found is tilted by {tilt:deg.1}° and displaced by {offset:m.2} m from the "
        "target on the other lines. It is another surface."
    ),
    "agreement.plane_beside": N_(
        "The plane found lies {distance:m.2|limit} m beside the target on the other lines, farther "
        "than the limit of {limit:m.2|distance} m. It is another surface."
    ),
    "finder.radius_differs": N_(
        "The sphere found has a radius of {radius:m.3} m, but on the line of the seed "
        "the radius is {expected:m.3} m."
    ),
    "finder.points_thinned": N_(
        "{target} on {line}: there are more than {most:n} points around the seed, so only "
        "one in {one_in:n} of them was used, chosen at random."
    ),
    "finder.radius_increased": N_(
        "{target}: within {usual:m} m of the seed a plane was found on fewer than "
        "two lines, so the search radius was increased to {radius:m} m."
    ),
    # -- quality of a sighting ---------------------------------------------------------------------
    "quality.curved": N_("The surface is curved, by {sagitta:mm.1} mm over its extent."),
    "quality.uneven": N_(
        "The surface is not flat: it deviates by {rms:mm.1} mm (RMS) from a smooth shape."
    ),
    "quality.oblique": N_("Oblique incidence ({angle:deg.0}°)."),
    "quality.sparse": N_(
        "The points cover only {share:percent.0} % of the area within the outline."
    ),
    "quality.sphere_part": N_("Only {share:percent.0} % of the surface of the sphere is visible."),
    "quality.few_points": N_("The sighting has only {count:n} points."),
    "quality.rough": N_(
        "The residuals (RMS {rms:mm.1} mm) are {ratio:x.1} times the noise, so the surface is "
        "rough or not flat."
    ),
    "quality.rough_without_prior": N_(
        "The residuals (RMS {rms:mm.1} mm) are {ratio:x.1} times the noise ({without:x.1} times "
        "without the effect of the prior boresight), so the surface is rough or not flat."
    ),
    "quality.rough_beyond_threshold": N_(
        "The residuals (RMS {rms:mm.1} mm) are {ratio:x.1} times the noise, so the surface is "
        "rough or not flat. More of its points lie beyond the threshold of {threshold:mm.0} mm."
    ),
    "quality.rough_without_prior_beyond_threshold": N_(
        "The residuals (RMS {rms:mm.1} mm) are {ratio:x.1} times the noise ({without:x.1} times "
        "without the effect of the prior boresight), so the surface is rough or not flat. More of "
        "its points lie beyond the threshold of {threshold:mm.0} mm."
    ),
    "quality.shows_more": N_(
        "On this line a larger area was found than on any other line: {sides:names}. Part of it "
        "may not belong to the target."
    ),
    "quality.shows_less": N_(
        "On this line only {share:percent.0} % of the area found on the other lines is visible: "
        "{sides:names}."
    ),
    "quality.width_alone": N_("{here:m.2} m wide (other lines: {there:m.2} m)"),
    "quality.height_alone": N_("{here:m.2} m high (other lines: {there:m.2} m)"),
    "quality.width_of": N_("{here:m.2} m of {there:m.2} m in width"),
    "quality.height_of": N_("{here:m.2} m of {there:m.2} m in height"),
    "quality.mistakable": Advised(
        N_(
            "A similar surface lies {distance:m.2} m away, and the surroundings do not determine "
            "which of the two is the target on this line."
        ),
        N_("Check the sighting in the cross-section."),
    ),
    "quality.wider": N_(
        "The surface is {size:m.2} m wide, {off:m.2} m more than the expected {expected:m.2} m."
    ),
    "quality.narrower": N_(
        "The surface is {size:m.2} m wide, {off:m.2} m less than the expected {expected:m.2} m."
    ),
    "quality.higher": N_(
        "The surface is {size:m.2} m high, {off:m.2} m more than the expected {expected:m.2} m."
    ),
    "quality.lower": N_(
        "The surface is {size:m.2} m high, {off:m.2} m less than the expected {expected:m.2} m."
    ),
    "quality.steeper": N_(
        "The surface is tilted by {tilt:deg.1}°, {off:deg.1}° more than the expected "
        "{expected:deg.1}°."
    ),
    "quality.less_steep": N_(
        "The surface is tilted by {tilt:deg.1}°, {off:deg.1}° less than the expected "
        "{expected:deg.1}°."
    ),
    # -- targets with points in common -------------------------------------------------------------
    "overlap.same_surface": N_(
        "{target} and {other} are the same surface: on {line} they have {share:percent.0} % of the "
        "points of {smaller} in common. Keep only one of them."
    ),
    "overlap.same_surface_twice": N_(
        "{target} and {other} are the same surface: on {line} they have {share:percent.0} % of the "
        "points of {smaller} in common, which would count twice. Keep only one of them."
    ),
    "overlap.same_surface_unchecked": N_(
        "{target} and {other} are the same surface ({share:percent.0} % of the points of {smaller} "
        "in common on {line}), so the validation plane is no independent check. Keep only one of "
        "them."
    ),
    "overlap.points_shared": N_(
        "{target} and {other} have points in common: on {line} {share:percent.0} % of the points "
        "of {smaller}. Keep only one of them."
    ),
    "overlap.points_shared_twice": N_(
        "{target} and {other} have points in common: on {line} {share:percent.0} % of the points "
        "of {smaller}, which would count twice. Keep only one of them."
    ),
    "overlap.points_shared_unchecked": N_(
        "{target} and {other} have points in common ({share:percent.0} % of the points of "
        "{smaller} on {line}), so the validation plane is no independent check. Keep only one of "
        "them."
    ),
}

"""Texts of messages about targets and the search for them."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- planes and spheres through points ---------------------------------------------------------
    "target.plane_few_points": N_(
        "A plane needs at least three points (number of points: {count:n})."
    ),
    "target.plane_not_finite": N_("A plane cannot be fitted: some points have no coordinates."),
    "target.plane_on_line": N_("The points lie on one straight line and do not determine a plane."),
    "target.sphere_radius": N_(
        "A sphere cannot have a radius of {radius:m} m. Give a length above zero."
    ),
    "target.sphere_few_points": N_(
        "A sphere needs at least four points (number of points: {count:n})."
    ),
    "target.sphere_not_finite": N_("A sphere cannot be fitted: some points have no coordinates."),
    "target.sphere_in_plane": N_("The points lie in one plane and do not determine a sphere."),
    "target.sphere_little_curved": N_(
        "The points show too little curvature for their noise to determine the radius of a sphere. "
        "Give the radius, or select more of the surface."
    ),
    "target.sphere_small_part": N_(
        "The points cover too small a part of a sphere of this radius to determine its centre. "
        "Select more of the surface."
    ),
    "target.sphere_side": N_(
        "The points are too flat to determine on which side of them the centre of the sphere lies. "
        "Select more of the surface."
    ),
    # -- measuring and display ---------------------------------------------------------------------
    "target.angle_same_points": N_(
        "Two of the points are the same. An angle needs three different points."
    ),
    "target.section_vertical": N_(
        "The two points lie above each other, so the section has no direction. Choose points that "
        "are apart horizontally."
    ),
    "target.point_spacing": N_("The point spacing must be a finite number of metres. Correct it."),
    # -- settings of the search --------------------------------------------------------------------
    "finder.setting": N_(
        "The search for planes cannot use {name} = {value}. Correct this setting."
    ),
    "finder.expected_size": N_("The expected width and height must be above zero. Correct them."),
    "finder.expected_tilt": N_("The expected tilt must be from 0 to 90 deg. Correct it."),
    "finder.radii": N_(
        "A sphere cannot be searched for with radii from {least:m} to {most:m} m. Give two lengths "
        "above zero, the smaller one first."
    ),
    "finder.seed": N_("The seed must be three finite numbers: north, west and up, in metres."),
    # -- search in one line ------------------------------------------------------------------------
    "finder.place": N_("({north:m.2}; {west:m.2}; {up:m.2})"),
    "finder.few_points": Plural(
        "Only {count:n} point lies within {radius:m} m of {place}, and a target needs {needed:n}. "
        "Move the seed, or increase the search radius.",
        "Only {count:n} points lie within {radius:m} m of {place}, and a target needs {needed:n}. "
        "Move the seed, or increase the search radius.",
    ),
    "finder.no_points": N_(
        "No points lie within {radius:m} m of {place}. The nearest is {distance:m.2} m away. Move "
        "the seed, or increase the search radius."
    ),
    "finder.no_points_near": N_(
        "No points lie within {radius:m} m of {place}. Move the seed, or increase the search "
        "radius."
    ),
    "finder.no_plane": N_("No plane fits the points around {place} within {threshold:mm} mm."),
    "finder.plane_few_points": Plural(
        "The flat patch around {place} has only {count:n} point, and a target needs {needed:n}. "
        "Try a threshold above {threshold:mm} mm.",
        "The flat patch around {place} has only {count:n} points, and a target needs {needed:n}. "
        "Try a threshold above {threshold:mm} mm.",
    ),
    "finder.other_tilt": N_("The plane around {place} has another orientation than expected."),
    "finder.sphere_of_radius": N_("sphere of radius {radius:m.3} m"),
    "finder.sphere_of_radii": N_("sphere with a radius from {least:m.3} to {most:m.3} m"),
    "finder.sphere_few_nearby": Plural(
        "Only {count:n} point lies within {radius:m} m of {place}, where a {sphere} would be, and "
        "a target needs {needed:n}. Set the seed on the sphere.",
        "Only {count:n} points lie within {radius:m} m of {place}, where a {sphere} would be, and "
        "a target needs {needed:n}. Set the seed on the sphere.",
    ),
    "finder.no_sphere": N_("No {sphere} fits the points around {place} within {threshold:mm} mm."),
    "finder.sphere_few_points": Plural(
        "The sphere around {place} has only {count:n} point, and a target needs {needed:n}. Try a "
        "threshold above {threshold:mm} mm.",
        "The sphere around {place} has only {count:n} points, and a target needs {needed:n}. Try a "
        "threshold above {threshold:mm} mm.",
    ),
    "finder.sphere_other_radius": N_(
        "The surface around {place} is round with a radius of {radius:m.3} m, but the search is "
        "for a {sphere}."
    ),
    "finder.sphere_far": N_(
        "The nearest sphere lies {distance:m.2} m from {place}. Set the seed on the sphere."
    ),
    "finder.sphere_continues": Plural(
        "A {sphere} around {place} touches {count:n} point, but the surface continues beside it "
        "with {beside:n} more. It is not a sphere, has another radius, or is noisier than the "
        "threshold allows.",
        "A {sphere} around {place} touches {count:n} points, but the surface continues beside it "
        "with {beside:n} more. It is not a sphere, has another radius, or is noisier than the "
        "threshold allows.",
    ),
    "finder.sphere_small_part": N_(
        "The points around {place} cover only {share:percent.0} % of a sphere's surface. A target "
        "needs at least {needed:percent.0} %."
    ),
    "finder.sphere_flat": N_("The surface around {place} is flat rather than a sphere."),
    # -- search in all lines -----------------------------------------------------------------------
    "finder.unknown_line": N_("There is no line named {line}."),
    "finder.no_line_for_plane": N_("There is no line in which to search for a plane."),
    "finder.no_line_for_sphere": N_("There is no line in which to search for a sphere."),
    "finder.no_plane_in_lines": N_(
        "No line has a plane at the seed. In the nearest line, {line}: {reason}"
    ),
    "finder.no_sphere_in_lines": N_(
        "No line has a sphere at the seed. In the nearest line, {line}: {reason}"
    ),
    "finder.line_few_points": Plural(
        "The line has only {count:n} point within {radius:m} m of the seed.",
        "The line has only {count:n} points within {radius:m} m of the seed.",
    ),
    "finder.line_no_points": N_("The line has no points within {radius:m} m of the seed."),
    "finder.not_alike": N_("Nothing in this line resembles the target and its surroundings."),
    "finder.too_few_where_expected": N_(
        "The line has too few points at the predicted position of the target."
    ),
    "finder.small_part": N_(
        "The plane found covers only {share:percent.0} % of the target's outline."
    ),
    "finder.too_large": N_("The plane found is {ratio:x.1} times as large as the target."),
    "finder.crossing": N_("The points found belong to a surface that crosses the target."),
    "finder.two_planes": N_(
        "Two planes {distance:m.2} m apart resemble the target equally. Set a separate seed for "
        "this line."
    ),
    "finder.two_spheres": N_(
        "Two spheres {distance:m.2} m apart resemble the target equally. Set a separate seed for "
        "this line."
    ),
    "agreement.no_overlap": N_(
        "Only {share:percent.0} % of the plane found lies within the target's outline in the "
        "other lines. It is another surface."
    ),
    "agreement.sphere_apart": N_(
        "The sphere found is {distance:m.2} m from the target in the other lines, but at most "
        "{limit:m.2} m are possible."
    ),
    "agreement.other_plane": N_(
        "The plane found is tilted by {tilt:deg.1} deg to the target in the other lines and lies "
        "{offset:m.2} m in front of or behind it. It is another surface."
    ),
    "agreement.plane_beside": N_(
        "The plane found is {distance:m.2} m beside the target in the other lines, but at most "
        "{limit:m.2} m are possible. It is another surface."
    ),
    "finder.radius_differs": N_(
        "The sphere found has a radius of {radius:m.3} m, but in the line of the seed the radius "
        "is {expected:m.3} m."
    ),
    "finder.points_thinned": N_(
        "{target} on {line}: there are more than {most:n} points around the seed. One in "
        "{one_in:n} of them was used, chosen at random."
    ),
    "finder.radius_increased": N_(
        "{target}: fewer than two lines have a plane within {usual:m} m of the seed. The search "
        "radius was increased to {radius:m} m."
    ),
    # -- quality of a sighting ---------------------------------------------------------------------
    "quality.curved": N_("It is curved: {sagitta:mm.1} mm over its extent."),
    "quality.uneven": N_(
        "It is not flat: it deviates by {rms:mm.1} mm (RMS) from its smooth shape."
    ),
    "quality.oblique": N_("The beams meet it at {angle:deg.0} deg from its normal."),
    "quality.sparse": N_("The points cover only {share:percent.0} % of its outline."),
    "quality.sphere_part": N_("Only {share:percent.0} % of its surface is visible."),
    "quality.few_points": N_("It has only {count:n} points."),
    "quality.rough": N_(
        "Its RMS of {rms:mm.1} mm is {ratio:x.1} times the noise: it is rough or not flat."
    ),
    "quality.rough_without_prior": N_(
        "Its RMS of {rms:mm.1} mm is {ratio:x.1} times the noise ({without:x.1} times without the "
        "effect of the prior boresight): it is rough or not flat."
    ),
    "quality.rough_beyond_threshold": N_(
        "Its RMS of {rms:mm.1} mm is {ratio:x.1} times the noise: it is rough or not flat, and "
        "more of it lies beyond the threshold of {threshold:mm.0} mm."
    ),
    "quality.rough_without_prior_beyond_threshold": N_(
        "Its RMS of {rms:mm.1} mm is {ratio:x.1} times the noise ({without:x.1} times without the "
        "effect of the prior boresight): it is rough or not flat, and more of it lies beyond the "
        "threshold of {threshold:mm.0} mm."
    ),
    "quality.shows_more": N_("It shows more than any other line: {sides:names}."),
    "quality.shows_less": N_(
        "It shows {share:percent.0} % of what the other lines show: {sides:names}."
    ),
    "quality.width_alone": N_("{here:m.2} m wide (elsewhere {there:m.2} m)"),
    "quality.height_alone": N_("{here:m.2} m high (elsewhere {there:m.2} m)"),
    "quality.width_of": N_("{here:m.2} of {there:m.2} m wide"),
    "quality.height_of": N_("{here:m.2} of {there:m.2} m high"),
    "quality.mistakable": N_(
        "A similar surface lies {distance:m.2} m beside it, and the surroundings do not determine "
        "which of the two this line shows. Check it in the section."
    ),
    "quality.wider": N_(
        "It is {size:m.2} m wide, {off:m.2} m more than the {expected:m.2} m expected."
    ),
    "quality.narrower": N_(
        "It is {size:m.2} m wide, {off:m.2} m less than the {expected:m.2} m expected."
    ),
    "quality.higher": N_(
        "It is {size:m.2} m high, {off:m.2} m more than the {expected:m.2} m expected."
    ),
    "quality.lower": N_(
        "It is {size:m.2} m high, {off:m.2} m less than the {expected:m.2} m expected."
    ),
    "quality.steeper": N_(
        "It is inclined by {tilt:deg.1} deg, {off:deg.1} deg more than the {expected:deg.1} deg "
        "expected."
    ),
    "quality.less_steep": N_(
        "It is inclined by {tilt:deg.1} deg, {off:deg.1} deg less than the {expected:deg.1} deg "
        "expected."
    ),
    # -- a target that was found before ------------------------------------------------------------
    "overlap.same_surface": N_(
        "{target} is the same surface as {other}: on {line}, {share:percent.0} % of the points of "
        "{smaller} are the same. Keep one of the two."
    ),
    "overlap.same_surface_twice": N_(
        "{target} is the same surface as {other}: on {line}, {share:percent.0} % of the points of "
        "{smaller} are the same. They would count twice. Keep one of the two."
    ),
    "overlap.same_surface_unchecked": N_(
        "{target} is the same surface as {other}: on {line}, {share:percent.0} % of the points of "
        "{smaller} are the same. A validation plane on a target checks nothing. Keep one of the "
        "two."
    ),
    "overlap.points_shared": N_(
        "{target} shares points with {other}: on {line}, {share:percent.0} % of the points of "
        "{smaller} are the same. Keep one of the two."
    ),
    "overlap.points_shared_twice": N_(
        "{target} shares points with {other}: on {line}, {share:percent.0} % of the points of "
        "{smaller} are the same. They would count twice. Keep one of the two."
    ),
    "overlap.points_shared_unchecked": N_(
        "{target} shares points with {other}: on {line}, {share:percent.0} % of the points of "
        "{smaller} are the same. A validation plane on a target checks nothing. Keep one of the "
        "two."
    ),
}

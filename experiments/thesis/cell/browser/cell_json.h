// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/thesis/cell/browser/recording.h"

namespace touchstone::cell::browser {

// Texts of JSON for the page. A pose is the twelve numbers of its upper rows, [R t], row by row. Drawn coordinates are
// the nearest floats.

/// Returns the part of a cell that the page shows independently of the run:
///   name, unit; piece: the name of what is handled, pieces: of all; elements: what its file consists of, [{kind, key,
///   name, listed, fields: [{path, value}]}]; zones: as zones_json draws them; sphere: its radius; robot: {name,
///   joints: [{name, lower, upper, home}]}, those that turn; setting: as read_setting takes it; drives: the names of
///   what may stop the robot; labels: {path: "T", "S", "D" or "C"} of it; bounds: {longest}; slots: [{name, place}];
///   storage, machine: {home, angle, radius, height, turn}; links, home_sphere: where they stand at home;
///   material_faces: where they look, in words: `top`, `underside`, `side`; parts: as part_json draws them,
///   of a finger also its number and the direction in which it closes (finger, closes).
[[nodiscard]] std::string cell_json(const Simulator& simulator);

/// Returns the part of a run that the page shows:
///   setting, labels; failure: text, empty if it completed; stuck: null, or where it ends early: {reason: a sentence,
///   parts: that touch, links, sphere, material, closed}; times: seconds at each stop, when the arm arrives there,
///   empty if a speed is unknown; waits: for how many it stays; cycle: the cycle time and what it assumes, in words;
///   separation: {elements, tolerance, least: [{mover, element, part, low, high, stop, seconds}], nearest: {mover:
///   {here, low, element}: lists by stop}} as in Separation; stations: {storage, machine}: poses; materials: {storage,
///   machine}: poses; stand: the part `storage/stand`, or null; moves: [{phase, joint, until, degrees, exact, contact:
///   null or {low, high, kind}, wrong: null or {early, gap}, rise, seconds}]; stops: [{move, commanded, links, sphere,
///   material, closed, place, target, nearest, distance, touched}]: the number of the move; poses; closed: the ways by
///   which the fingers have closed; place is null where the gripper has the material, target where the sphere comes for
///   nothing; then so is nearest, the face of the target that is nearest to the sphere's centre, at that distance from
///   it; disagreements: [{stop, owner, face, methods}]; transfers: [{stop, grip: null or {opening, faces: by finger},
///   landing: null or {support, gap}}]; triggers: [{zone, mover, part, after, degrees, until}], as in Trigger.
/// Faces are numbers of SolidFaces::faces of the material.
[[nodiscard]] std::string run_json(const Recording& recording);

/// Returns the arm at a pose: links, sphere; hindrance: null or {what, parts}; nearest: [{mover, element, distance}].
[[nodiscard]] std::string pose_json(const Posed& posed);
/// Returns the outcomes at some radii: [{radius, cause: null if it completes, reason}].
[[nodiscard]] std::string area_json(const std::vector<Tried>& tried);

}  // namespace touchstone::cell::browser

// SPDX-License-Identifier: GPL-3.0-or-later
// Where answers come from: the program that serves the page, or the run that is recorded in it.

/// What the program said instead of an answer.
class Refused extends Error {}

function answersOf(recorded, variation) {
  if (recorded) {
    return {
      live: false,
      cell: async () => recorded.cell,
      run: async () => recorded.run,
      presets: async () => [],
    };
  }
  const ask = async (path, options) => {
    let reply;
    try {
      reply = await fetch(path, options);
    } catch {
      throw new Refused("the program does not answer; is `touchstone cell serve` still running?");
    }
    const answer = await reply.json();
    if (!reply.ok) throw new Refused(answer.error);
    return answer;
  };
  const varied = isVaried(variation) ? (variation.piece ? variation : {changes: variation.changes}) : {};
  const preset = +new URLSearchParams(location.search).get("preset") || 0, behind = preset ? `/${preset}` : "";
  const post = (name) => (body) =>
    ask(`/api/${name}${behind}`, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify({...body, ...varied})});
  return {
    live: true,
    preset,
    presets: () => ask("/api/presets"),
    cell: () => (isVaried(variation) ? post("varied")({}) : ask(`/api/cell${behind}`)),
    run: post("run"),
    pose: post("pose"),
    area: post("area"),
  };
}

// SPDX-License-Identifier: GPL-3.0-or-later
// How the perspective view is turned and approached: by pointers, the wheel, keys and buttons.

function listenToView(scene, draw) {
  const canvas = at("scene"), pointers = new Map();
  let spread = 0;
  const closeAt = (event) => {
    const box = canvas.getBoundingClientRect(), x = event.clientX - box.left, y = box.bottom - event.clientY;
    return scene.views(box.width, box.height).some(([near, left, below, width, height]) => near && x >= left && x <= left + width && y >= below && y <= below + height);
  };
  const apart = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  canvas.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 2) spread = apart();
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (pointers.size === 1) scene.turn(-0.4 * (event.clientX - last[0]), 0.4 * (event.clientY - last[1]));
    if (pointers.size === 2) scene.approach(spread / apart(), closeAt(event)), spread = apart();
    draw();
  });
  const end = (event) => pointers.delete(event.pointerId);
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    scene.approach(Math.exp(event.deltaY / 800), closeAt(event));
    draw();
  }, {passive: false});
  canvas.addEventListener("keydown", (event) => {
    const act = {
      ArrowLeft: () => scene.turn(-5, 0), ArrowRight: () => scene.turn(5, 0), ArrowUp: () => scene.turn(0, 5), ArrowDown: () => scene.turn(0, -5),
      "+": () => scene.approach(0.9), "=": () => scene.approach(0.9), "-": () => scene.approach(1 / 0.9),
    }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
    draw();
  });
  for (const button of document.querySelectorAll("[data-look]"))
    button.addEventListener("click", () => {
      const look = button.dataset.look;
      look === "near" ? scene.lookNear() : look === "split" ? scene.lookSplit() : scene.look(look);
      document.querySelector("[data-look=split]").setAttribute("aria-pressed", scene.split);
      draw();
    });
  at("follow").addEventListener("change", () => (scene.follows = at("follow").checked, draw()));
  new ResizeObserver(draw).observe(canvas);
}

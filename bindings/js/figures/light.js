// SPDX-License-Identifier: MIT
// A handle for the direction to a light: its place on a half sphere that is seen from the front.

const RIM = 0.98;  // lights stay in front of the picture

export class LightHandle {
  constructor(x, y) {
    this.place = [x, y];
  }
  /** The unit vector to the light; z points to the eye. */
  get direction() {
    const [x, y] = this.place;
    return [x, y, Math.sqrt(Math.max(0, 1 - x * x - y * y))];
  }
  /** The handle over a panel. */
  handle({ x, y, width, height }) {
    const [left, top, radius] = [x + width / 2, y + height / 2, Math.min(width, height) / 2];
    return {
      label: "Light", fill: "#ffd34d",
      at: [left + this.place[0] * radius, top - this.place[1] * radius],
      move: (i, j) => {
        const place = [(i - left) / radius, (top - j) / radius];
        const length = Math.max(1, Math.hypot(...place) / RIM);
        this.place = place.map((v) => v / length);
      },
    };
  }
}

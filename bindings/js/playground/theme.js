// SPDX-License-Identifier: MIT
// Light or dark colours: those of the system, until the button chooses. The choice is kept for later visits.
(() => {
  const root = document.documentElement;
  const stored = (value) => {
    try {
      return value ? localStorage.setItem("theme", value) : localStorage.getItem("theme");
    } catch {
      return null;  // pages in some frames have no storage
    }
  };
  const system = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => (root.dataset.theme ? root.dataset.theme === "dark" : system.matches);
  const theme = stored();
  if (theme === "light" || theme === "dark") root.dataset.theme = theme;
  addEventListener("DOMContentLoaded", () => {
    const button = document.querySelector("#theme");
    const show = () => { button.ariaPressed = String(isDark()); };
    button.addEventListener("click", () => {
      root.dataset.theme = isDark() ? "light" : "dark";
      stored(root.dataset.theme);
      show();
    });
    system.addEventListener("change", show);
    show();
  });
})();

// SPDX-License-Identifier: MIT
"use strict";

// The reference follows the colours of the manual, and a choice made here holds there: both keep it in localStorage.
{
  const manual = new URL("../", location).pathname + ".__palette";
  const isSystemDark = matchMedia("(prefers-color-scheme: dark)").matches;
  const palette = JSON.parse(localStorage.getItem(manual));
  const isDark = palette ? palette.color.scheme === "slate" : isSystemDark;
  const keep = (name, value) => (value ? localStorage.setItem(name, true) : localStorage.removeItem(name));
  keep("prefers-dark-mode-in-light-mode", !isSystemDark && isDark);
  keep("prefers-light-mode-in-dark-mode", isSystemDark && !isDark);
  document.addEventListener("click", event => {
    if (!event.composedPath().some(node => node.localName === "doxygen-awesome-dark-mode-toggle")) return;
    const scheme = document.documentElement.classList.contains("dark-mode") ? "slate" : "default";
    const color = { scheme, primary: "blue-grey", accent: "light-blue" };
    localStorage.setItem(manual, JSON.stringify({ index: scheme === "slate" ? 1 : 0, color }));
  });
}

// The search of the manual has the address shadow_8h.html?shd_shadow_create for a part of a page.
addEventListener("load", () => {
  const [name] = new URLSearchParams(location.search).keys();
  for (const title of document.querySelectorAll("h2.memtitle")) {
    if (title.lastChild.textContent.replace("()", "") !== name) continue;
    location.replace(title.querySelector("a").hash);
    break;
  }
});

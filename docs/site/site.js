// SPDX-License-Identifier: MIT
// Formulas of the pages: arithmatex leaves them in \(...\) and \[...\].
"use strict";

for (const formula of document.querySelectorAll(".arithmatex")) {
  renderMathInElement(formula, {
    delimiters: [{ left: "\\(", right: "\\)", display: false }, { left: "\\[", right: "\\]", display: true }],
    throwOnError: true,
  });
}

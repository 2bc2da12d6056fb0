// SPDX-License-Identifier: MIT
// The search of pages that are opened as files. The index comes from search_index.js, under the name that newer versions of
// the theme take, and the worker runs in a frame.
"use strict";

window.__search = { index: Promise.resolve(__index) };

window.Worker = class extends EventTarget {
  constructor(address) {
    super();
    this.waiting = [];
    this.frame = document.createElement("iframe");
    this.frame.hidden = true;
    this.frame.srcdoc = `<script>postMessage = data => frameElement.answer(data);</` +
      `script><script src="${address}"></` + "script>";
    this.frame.answer = data => this.dispatchEvent(new MessageEvent("message", { data }));
    this.frame.onload = () => {
      const waiting = this.waiting;
      this.waiting = null;
      for (const data of waiting) this.postMessage(data);
    };
    document.body.append(this.frame);
  }

  postMessage(data) {
    if (this.waiting) this.waiting.push(data);
    else this.frame.contentWindow.dispatchEvent(new MessageEvent("message", { data }));
  }
};

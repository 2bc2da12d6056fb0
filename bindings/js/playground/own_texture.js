// SPDX-License-Identifier: MIT
// An image file of the visitor as a texture: dropped on the page, or chosen by the button. It stays in the browser.

const LARGEST = 2048;  // texels of a side

/** RGBA8 of an image file, white where it is transparent. */
async function readImage(file) {
  const image = await createImageBitmap(file);
  const scale = Math.min(1, LARGEST / Math.max(image.width, image.height));
  const [width, height] = [image.width, image.height].map((size) => Math.max(1, Math.round(size * scale)));
  const paper = new OffscreenCanvas(width, height).getContext("2d");
  paper.fillStyle = "#fff";
  paper.fillRect(0, 0, width, height);
  paper.imageSmoothingQuality = "high";
  paper.drawImage(image, 0, 0, width, height);
  return { width, height, texels: new Uint8Array(paper.getImageData(0, 0, width, height).data.buffer) };
}

/** Calls `onTexture` with each image. `say` shows a sentence. */
export function openTexture(onTexture, say) {
  const open = async (file) => {
    if (!file) return;
    try {
      const texture = await readImage(file);
      await onTexture(texture);
      say(`${file.name}: ${texture.width} × ${texture.height} texels`);
    } catch {
      say(`${file.name} is not an image that this browser reads.`);
    }
  };
  const input = document.querySelector("#own");
  input.addEventListener("change", () => { open(input.files[0]); input.value = ""; });
  const hasFile = (event) => event.dataTransfer?.types.includes("Files");
  addEventListener("dragover", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) document.body.classList.remove("dropping");
  });
  addEventListener("drop", (event) => {
    document.body.classList.remove("dropping");
    if (!hasFile(event)) return;
    event.preventDefault();
    open(event.dataTransfer.files[0]);
  });
}

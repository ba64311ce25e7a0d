// Has no look of its own. It tells the page that there is a desk, and Python when the student has closed it, so that the next
// `desk()` opens one.
export default {
  render({ model, el }) {
    let here = true;
    el.parentElement.classList.add("ck-floor");
    const closed = () => { if (here && !el.parentElement.querySelector(".ck-veil")) model.send({ type: "closed" }); };
    const tell = () => {
      if (!here) return;
      if (el.isConnected) document.dispatchEvent(new CustomEvent("coursekit-desk", { detail: { el, closed } }));
      else requestAnimationFrame(tell);
    };
    tell();
    return () => { here = false; };
  },
};

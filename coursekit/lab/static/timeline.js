// The time line: a slider over the last minutes, which all panels follow.
const clock = (seconds) => `${Math.floor(seconds / 60)}:${(seconds % 60).toFixed(1).padStart(4, "0")}`;

export default {
  render({ model, el }) {
    const { panel, head, body } = frame(el, "timeline", gettext("Time line"));
    const press = (button) => model.send({ type: "press", button });
    const play = make("button", { onclick: () => press(play.dataset.does) });
    const live = make("button", { textContent: gettext("Live"), title: gettext("show what happens now"), onclick: () => press("live") });
    const slider = make("input", { type: "range", max: 0, step: "any", oninput: () => { held = true; model.send({ type: "go", ago: -Number(slider.value) }); } });
    slider.setAttribute("aria-label", gettext("how long ago"));
    slider.addEventListener("change", () => { held = false; });
    const when = make("span", { className: "ck-when" }), reach = make("span", { className: "ck-dim" });
    let held = false;
    head.append(play, live);
    body.append(reach, slider, when);
    return listen(model, {
      shown(said) {
        panel.classList.toggle("ck-back", !said.live);
        slider.min = -Math.max(said.reach, 1);
        if (!held) slider.value = -said.ago;
        reach.textContent = `−${clock(said.reach)}`;
        when.textContent = said.live ? gettext("now") : gettext("{0} ago", clock(said.ago));
        slider.setAttribute("aria-valuetext", when.textContent);
        play.dataset.does = said.live || said.playing ? "pause" : "play";
        play.textContent = said.live || said.playing ? gettext("Pause") : gettext("Play");
        play.title = said.live || said.playing ? gettext("stay at this picture; robots drive on") : gettext("go on from there");
        live.hidden = said.live;
      },
    });
  },
};

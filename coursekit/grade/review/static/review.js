// Saves each field when it is left, and goes from field to field and from student to student by the keyboard.
// On the page of the class it goes from name to name; Enter opens one, as in every link.
const key = document.body.dataset.key;
const saved = document.getElementById("saved");
const points = () => [...document.querySelectorAll("input[name=points]")];

async function save(field) {
  if (field.value === field.dataset.kept) return true;
  const body = { exercise: field.form.dataset.exercise, [field.name]: field.value };
  let said;
  try {
    const answer = await fetch(`${key}.html`, { method: "POST", body: JSON.stringify(body) });
    said = await answer.json();
  } catch {
    said = { error: "It is not saved: the marking has ended. Run the command again." };
  }
  saved.textContent = said.error ?? (said.told || "Saved");
  saved.classList.toggle("wrong", "error" in said);
  if (said.error) return false;
  field.dataset.kept = field.value;
  document.querySelector(".total b").textContent = said.total;
  document.querySelector("footer .status").textContent = said.status;
  if (said.verdict) field.closest(".work").querySelector(".said").innerHTML = said.verdict;
  return true;
}

function go(step) {
  const fields = points();
  const at = fields.indexOf(document.activeElement.form?.querySelector("input[name=points]"));
  const to = fields[Math.max(0, Math.min(fields.length - 1, at < 0 ? 0 : at + step))];
  if (!to) return;
  to.focus();
  to.select();
  to.closest(".work").scrollIntoView({ block: "start" });
  history.replaceState(null, "", `#at=${to.form.dataset.exercise}`);
}

function student(id, step) {
  const names = [...document.querySelectorAll("#everybody td:first-child a")];
  if (names.length) {
    const at = names.indexOf(document.activeElement);
    const name = names[Math.max(0, Math.min(names.length - 1, at < 0 ? 0 : at + step))];
    name.focus();
    name.closest("td").scrollIntoView({ block: "nearest" });
    return;
  }
  const href = document.getElementById(id)?.getAttribute("href") ?? "#";
  if (href !== "#") location.href = href + location.hash;
}

for (const field of document.querySelectorAll(".marks input, .marks textarea")) {
  field.dataset.kept = field.value;
  field.addEventListener("change", () => save(field));
  field.addEventListener("keydown", async (event) => {
    if (event.key === "Escape") field.blur();
    if (event.key !== "Enter" || (field.tagName === "TEXTAREA" && event.shiftKey)) return;
    event.preventDefault();
    if (await save(field)) go(1);
  });
}
document.addEventListener("submit", (event) => event.preventDefault());

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "TEXTAREA") return;
  const comment = document.activeElement.form?.querySelector("textarea") ?? document.querySelector(".marks textarea");
  const moves = { j: () => student("next", 1), k: () => student("before", -1), n: () => go(1), p: () => go(-1),
    c: () => comment?.focus(), u: () => document.getElementById("class")?.click() };
  if (!moves[event.key]) return;
  event.preventDefault();
  moves[event.key]();
});

// The hash is no id of an element: the browser would go there itself, and take the focus away.
const first = points().find((field) => `#at=${field.form.dataset.exercise}` === location.hash);
if (first) {
  first.focus();
  first.select();
  first.closest(".work").scrollIntoView({ block: "start" });
}

// Words in the course's language, of the dictionary above; {0}, {1}, ... stand for what is put in.
function gettext(text, ...values) {
  return (WORDS[text] ?? text).replace(/\{(\d+)\}/g, (field, number) => values[number] ?? field);
}

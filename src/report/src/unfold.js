// A link to a folded section opens it.
function unfold() {
  var part = location.hash && document.getElementById(location.hash.slice(1));
  var folded = part && (part.closest('details.folded') || part.querySelector('details.folded'));
  if (folded) { folded.open = true; part.scrollIntoView(); }
}
window.addEventListener('hashchange', unfold);
unfold();

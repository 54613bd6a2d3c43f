// A page with wings shows them.

var holder = document.getElementById("wing-data"), place = document.getElementById("wing-canvas");
var data = holder && JSON.parse(holder.textContent);
if (data && place && place.getContext) start(place);

// Assembles the page.
fillHead();
fillFindings();
fillTables();
fillDays();
fillTimeline();
fillNotes();
fillPictures();
fillOrigins();

showChips();
const map = new MissionMap(document.getElementById('map'));
showPlots([...plotSpecs().map(spec => new Plot(spec)), ...(page.sight.length > 0 ? [new SightPlot()] : [])]);
setCursor(endS);

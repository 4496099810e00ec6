// What is measured of a scene after its picture is drawn, in the second worker: hash, time and charts.

/** Empties the facts of a new scene until they are measured. */
function forget() {
  const key = `${page.scene.index} ${page.scene.text}`;
  if (page.measured === key) return;
  page.measured = key;
  page.isMeasured = false;
  const known = knownScene();
  showHash(null, known ? DATA.hashes[known.name] : undefined);
  if (isOnBoards(known)) showMeasuredBoards(DATA.boards, known.name);
  else showRoughBoards(DATA.boards, null);
}

/** Hash, time and charts, in the second worker. */
const measure = debounced(300, async () => {
  const { scene, view, frame } = request();
  if (!page.isMeasured) await measureScene(scene, page.measured);
  if (page.chartsNear) series.showErrors(scene, view, frame);
});

async function measureScene(scene, key) {
  const known = knownScene();
  const hash = await ifWanted(side.ask("hash", { scene, view: OWN_VIEW }));
  if (page.measured !== key) return;
  if (hash !== null) showHash(hash, known ? DATA.hashes[known.name] : undefined);
  page.isMeasured = true;
  if (!isOnBoards(known)) showRough(scene, key);
}

/** Estimates frames a second by the times of this scene and of castle, both measured here. */
async function showRough(scene, key) {
  const time = await ifWanted(side.ask("time", { scene }));
  const castle = time && (await ifWanted(side.ask("time", { scene: { text: sceneNamed("castle").json, index: -1 } })));
  if (!castle || page.measured !== key) return;
  page.castleTime = Math.min(page.castleTime, castle);
  showRoughBoards(DATA.boards, page.castleTime / time);
}

const isOnBoards = (known) => known !== undefined && DATA.boards.some((row) => row.scene === known.name);

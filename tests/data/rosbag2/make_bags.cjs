// Makes the bags of this folder with writers that are not ours: @mcap/core, @foxglove/rosmsg2-serialization and the
// command line programs zstd, lz4 and sqlite3. See README.md for how to run it.
//
// A robot drives a quarter of a circle among four posts. Every sensor is mounted in its own way, and every detection is
// exact, so that a test can place it on the map by the ground truth.
const { execFileSync } = require("child_process");
const fs = require("fs");
const path = require("path");
const { McapWriter } = require("@mcap/core");
const { parse, stringify } = require("@foxglove/rosmsg");
const { MessageWriter } = require("@foxglove/rosmsg2-serialization");
const { CdrWriter, EncapsulationKind } = require("@foxglove/cdr");
const { ros2humble } = require("@foxglove/rosmsg-msgs-common");

const folder = __dirname;

// ---- message definitions ----

const ownTypes = {
  "apriltag_msgs/AprilTagDetectionArray": `std_msgs/Header header
apriltag_msgs/AprilTagDetection[] detections`,
  "apriltag_msgs/AprilTagDetection": `string family
int32 id
int32 hamming
float32 goodness
float32 decision_margin
float64[2] centre
float64[8] corners
float64[9] homography`,
  "sick_scan_xd/NAVLandmarkData": `std_msgs/Header header
uint8 landmark_filter
uint16 num_reflectors
sick_scan_xd/NAVReflectorData[] reflectors`,
  "sick_scan_xd/NAVReflectorData": `uint16 cartesian_data_valid
int32 x
int32 y
uint16 polar_data_valid
uint32 dist
uint32 phi
uint16 opt_reflector_data_valid
uint16 local_id
uint16 global_id
uint8 type
uint16 sub_type
uint16 quality
uint32 timestamp
uint16 size
uint16 hit_count
uint16 mean_echo
uint16 start_index
uint16 end_index
int8 pos_valid
float32 pos_x
float32 pos_y`,
  "vision_msgs/Detection3DArray": `std_msgs/Header header
vision_msgs/Detection3D[] detections`,
  "vision_msgs/Detection3D": `std_msgs/Header header
vision_msgs/ObjectHypothesisWithPose[] results
vision_msgs/BoundingBox3D bbox
string id`,
  "vision_msgs/ObjectHypothesisWithPose": `vision_msgs/ObjectHypothesis hypothesis
geometry_msgs/PoseWithCovariance pose`,
  "vision_msgs/ObjectHypothesis": `string class_id
float64 score`,
  "vision_msgs/BoundingBox3D": `geometry_msgs/Pose center
geometry_msgs/Vector3 size`,
};

function fieldsOf(type) {
  if (ownTypes[type]) return parse(ownTypes[type], { ros2: true, skipTypeFixup: true })[0].definitions;
  return ros2humble[type].definitions;
}

/** The text of a type and of all in it, as rosbag2 stores it; stringify() takes times for known. */
function definitionOf(type) {
  const text = foxgloveDefinitionOf(type);
  if (!/^time /m.test(text)) return text;
  return text.replace(/^time /gm, "builtin_interfaces/Time ") + "=".repeat(80) + "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
}

function foxgloveDefinitionOf(type) {
  const types = [type];
  const parts = [];
  for (let i = 0; i < types.length; ++i) {
    const definitions = fieldsOf(types[i]);
    parts.push((i > 0 ? `MSG: ${types[i]}\n` : "") + stringify([{ definitions }]).trim() + "\n");
    for (const field of definitions) if (field.isComplex && !types.includes(field.type)) types.push(field.type);
  }
  return parts.join("=".repeat(80) + "\n");
}

const writers = new Map();
function encode(type, message) {
  if (!writers.has(type)) writers.set(type, new MessageWriter(parse(foxgloveDefinitionOf(type), { ros2: true })));
  return writers.get(type).writeMessage(message);
}

// ---- geometry: poses as {p: [x, y, z], r: rows of the rotation matrix} ----

const rotX = (a) => [[1, 0, 0], [0, Math.cos(a), -Math.sin(a)], [0, Math.sin(a), Math.cos(a)]];
const rotY = (a) => [[Math.cos(a), 0, Math.sin(a)], [0, 1, 0], [-Math.sin(a), 0, Math.cos(a)]];
const rotZ = (a) => [[Math.cos(a), -Math.sin(a), 0], [Math.sin(a), Math.cos(a), 0], [0, 0, 1]];
const times = (a, b) => a.map((row) => b[0].map((_, j) => row.reduce((sum, v, k) => sum + v * b[k][j], 0)));
const rotated = (r, v) => r.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
const transposed = (r) => r[0].map((_, j) => r.map((row) => row[j]));
const plus = (a, b) => a.map((v, i) => v + b[i]);
const compose = (a, b) => ({ p: plus(a.p, rotated(a.r, b.p)), r: times(a.r, b.r) });
const inverse = (a) => ({ p: rotated(transposed(a.r), a.p).map((v) => -v), r: transposed(a.r) });
const seenFrom = (pose, point) => rotated(transposed(pose.r), plus(point, pose.p.map((v) => -v)));
const deg = Math.PI / 180;

function quaternion(r) {
  const w = Math.sqrt(Math.max(0, 1 + r[0][0] + r[1][1] + r[2][2])) / 2;
  const x = Math.sqrt(Math.max(0, 1 + r[0][0] - r[1][1] - r[2][2])) / 2;
  const y = Math.sqrt(Math.max(0, 1 - r[0][0] + r[1][1] - r[2][2])) / 2;
  const z = Math.sqrt(Math.max(0, 1 - r[0][0] - r[1][1] + r[2][2])) / 2;
  const signed = (value, a, b) => (a >= b ? value : -value);
  if (w > 1e-6) return { x: signed(x, r[2][1], r[1][2]), y: signed(y, r[0][2], r[2][0]), z: signed(z, r[1][0], r[0][1]), w };
  if (x > 1e-6) return { x, y: signed(y, r[0][1], 0), z: signed(z, r[0][2], 0), w };
  return y > 1e-6 ? { x, y, z: signed(z, r[1][2], 0), w } : { x, y, z, w };
}
const xyz = (v) => ({ x: v[0], y: v[1], z: v[2] });
const poseMessage = (pose) => ({ position: xyz(pose.p), orientation: quaternion(pose.r) });

// ---- the scene ----

const optical = [[0, 0, 1], [-1, 0, 0], [0, -1, 0]];
const mounts = {
  laser: { p: [0.2, 0.1, 0.3], r: times(rotZ(30 * deg), rotX(Math.PI)) }, // upside down
  nav: { p: [-0.1, 0, 1], r: rotZ(90 * deg) },
  camera_optical: { p: [0.15, -0.05, 0.6], r: times(rotY(-10 * deg), optical) }, // looks up
};
const posts = [
  { id: 1, p: [4, 0.5, 1] },
  { id: 2, p: [0.5, 4, 1] },
  { id: 3, p: [-3, -0.5, 1] },
  { id: 12, p: [1, -3.5, 1] },
];
const diameter = 0.1;
const start = 1700000000.25;
const poseAt = (t) => ({ p: [1.5 * Math.cos(0.3 * t), 1.5 * Math.sin(0.3 * t), 0], r: rotZ(0.3 * t + Math.PI / 2) });

const header = (t, frame_id) => {
  const sec = Math.floor(start + t);
  return { stamp: { sec, nanosec: Math.round((start + t - sec) * 1e9) }, frame_id };
};
const transform = (t, frame, child, pose) => ({
  header: header(t, frame),
  child_frame_id: child,
  transform: { translation: xyz(pose.p), rotation: quaternion(pose.r) },
});

/** A scan of 271 beams over three quarters of a turn; posts are bright, the wall 9 m away is dark. */
function scan(t) {
  const T_map_laser = compose(poseAt(t), mounts.laser);
  const ranges = [], intensities = [];
  for (let beam = 0; beam <= 270; ++beam) {
    const angle = (-135 + beam) * deg;
    let range = 9, intensity = 20;
    for (const post of posts) {
      const [x, y] = seenFrom(T_map_laser, [post.p[0], post.p[1], T_map_laser.p[2]]);
      const along = x * Math.cos(angle) + y * Math.sin(angle), across = y * Math.cos(angle) - x * Math.sin(angle);
      if (along < 0 || Math.abs(across) > diameter / 2) continue;
      range = along - Math.sqrt((diameter / 2) ** 2 - across ** 2);
      intensity = 3000;
    }
    ranges.push(range);
    intensities.push(intensity);
  }
  return {
    header: header(t, "laser"), angle_min: -135 * deg, angle_max: 135 * deg, angle_increment: deg, time_increment: 0,
    scan_time: 0.1, range_min: 0.05, range_max: 30, ranges, intensities,
  };
}

function reflectors(t) {
  const T_map_nav = compose(poseAt(t), mounts.nav);
  const none = { cartesian_data_valid: 0, x: 0, y: 0, polar_data_valid: 0, dist: 0, phi: 0, opt_reflector_data_valid: 0,
    local_id: 0, global_id: 0, type: 0, sub_type: 0, quality: 0, timestamp: 0, size: 0, hit_count: 0, mean_echo: 0,
    start_index: 0, end_index: 0, pos_valid: 0, pos_x: 0, pos_y: 0 };
  const seen = posts.map((post, i) => {
    const [x, y] = seenFrom(T_map_nav, [post.p[0], post.p[1], T_map_nav.p[2]]);
    // The scanner's own axes are turned by half a circle against those of its frame in ROS.
    const phi = Math.atan2(y, x) / deg + 180;
    if (i === 0) return { ...none, cartesian_data_valid: 1, x: Math.round(-1000 * x), y: Math.round(-1000 * y) };
    if (i === 1) return { ...none, polar_data_valid: 1, dist: Math.round(1000 * Math.hypot(x, y)), phi: Math.round(1000 * phi) };
    return { ...none, pos_valid: 1, pos_x: x, pos_y: y };
  });
  return { header: header(t, "nav"), landmark_filter: 0, num_reflectors: seen.length, reflectors: seen };
}

const camera = { fx: 300, fy: 310, cx: 320, cy: 240 };
function tagsInView(t) {
  const T_map_camera = compose(poseAt(t), mounts.camera_optical);
  const seen = [];
  for (const post of posts) {
    const v = seenFrom(T_map_camera, post.p);
    const pixel = [camera.cx + (camera.fx * v[0]) / v[2], camera.cy + (camera.fy * v[1]) / v[2]];
    if (v[2] > 0 && pixel[0] >= 0 && pixel[0] < 640 && pixel[1] >= 0 && pixel[1] < 480) seen.push({ id: post.id, v, pixel });
  }
  return seen;
}
const tags = (t) => ({
  header: header(t, "camera_optical"),
  detections: tagsInView(t).map(({ id, pixel }) => ({
    family: "tag36h11", id, hamming: 0, goodness: 0, decision_margin: 80, centre: pixel, corners: new Array(8).fill(0),
    homography: new Array(9).fill(0),
  })),
});
const cameraInfo = (t) => ({
  header: header(t, "camera_optical"), height: 480, width: 640, distortion_model: "plumb_bob", d: [0, 0, 0, 0, 0],
  k: [500, 0, 320, 0, 500, 240, 0, 0, 1], r: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  p: [camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0], binning_x: 0, binning_y: 0,
  roi: { x_offset: 0, y_offset: 0, height: 0, width: 0, do_rectify: false },
});

function objects(t) {
  const T_map_nav = compose(poseAt(t), mounts.nav);
  const covariance = new Array(36).fill(0);
  covariance[0] = covariance[7] = covariance[14] = 0.0004;
  const detections = posts.map((post, i) => {
    const pose = { position: xyz(seenFrom(T_map_nav, post.p)), orientation: { x: 0, y: 0, z: 0, w: 1 } };
    const results = i === 3 ? [] : [{ hypothesis: { class_id: i === 0 ? "post" : `post_${post.id}`, score: 0.9 }, pose: { pose, covariance } }];
    return { header: header(t, "nav"), results, bbox: { center: pose, size: { x: 0.1, y: 0.1, z: 2 } }, id: "" };
  });
  return { header: header(t, "nav"), detections };
}

// ---- the messages, in order of time ----

function messages() {
  const all = [];
  const add = (t, topic, type, message) => all.push({ t, topic, type, message });
  add(0, "/tf_static", "tf2_msgs/TFMessage", {
    transforms: [
      transform(0, "base_link", "laser", mounts.laser),
      transform(0, "base_link", "mast", { p: [0, 0, 1], r: rotZ(90 * deg) }),
      transform(0, "nav", "mast", compose(inverse(mounts.nav), { p: [0, 0, 1], r: rotZ(90 * deg) })), // written backwards
      transform(0, "base_link", "camera_optical", mounts.camera_optical),
    ],
  });
  const covariance = new Array(36).fill(0);
  for (let step = 0; step <= 50; ++step) {
    const t = step / 10;
    const truth = poseAt(t);
    const T_odom_base = compose(inverse(poseAt(0)), truth);
    const zero = { x: 0, y: 0, z: 0 };
    add(t, "/odom", "nav_msgs/Odometry", {
      header: header(t, "odom"), child_frame_id: "base_link", pose: { pose: poseMessage(T_odom_base), covariance },
      twist: { twist: { linear: { x: 0.45, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0.3 } }, covariance },
    });
    add(t, "/tf", "tf2_msgs/TFMessage", { transforms: [transform(t, "odom", "base_link", T_odom_base)] });
    add(t, "/ground_truth/pose", "geometry_msgs/PoseStamped", { header: header(t, "map"), pose: poseMessage(truth) });
    if (step % 10 !== 5) continue;
    add(t, "/scan", "sensor_msgs/LaserScan", scan(t));
    add(t, "/nav350/landmarks", "sick_scan_xd/NAVLandmarkData", reflectors(t));
    add(t, "/objects", "vision_msgs/Detection3DArray", objects(t));
    add(t, "/camera/camera_info", "sensor_msgs/CameraInfo", cameraInfo(t));
    add(t, "/camera/detections", "apriltag_msgs/AprilTagDetectionArray", tags(t));
    // The poses of the tags with odd steps only: a range needs the transform of its own time.
    if (step % 20 === 5 && tagsInView(t).length > 0)
      add(t, "/tf", "tf2_msgs/TFMessage", {
        transforms: tagsInView(t).map(({ id, v }) => transform(t, "camera_optical", `tag36h11:${id}`, { p: v, r: rotX(0) })),
      });
    const range = Math.hypot(...seenFrom(truth, posts[3].p));
    add(t, "/radio", "sensor_msgs/Range", {
      header: header(t, "anchor_12"), radiation_type: 0, field_of_view: 0, min_range: 0.1, max_range: 20,
      range: step === 25 ? Infinity : range,
    });
    add(t, "/goal_pose", "geometry_msgs/PoseStamped", { header: header(t, "map"), pose: poseMessage(poseAt(5)) });
    add(t, "/chatter", "std_msgs/String", { data: "hello" });
  }
  return all;
}

// ---- the writers ----

class FileWriter {
  constructor() { this.parts = []; this.size = 0n; }
  async write(bytes) { this.parts.push(Buffer.from(bytes)); this.size += BigInt(bytes.length); }
  position() { return this.size; }
}

async function writeMcap(name, options, chosen, textOf = definitionOf) {
  const file = new FileWriter();
  const writer = new McapWriter({ writable: file, ...options });
  await writer.start({ profile: "ros2", library: "" });
  const channels = new Map();
  for (const { t, topic, type, bytes } of chosen) {
    if (!channels.has(topic)) {
      const longType = type.replace("/", "/msg/");
      const schemaId = await writer.registerSchema({ name: longType, encoding: "ros2msg", data: new TextEncoder().encode(textOf(type)) });
      channels.set(topic, await writer.registerChannel({ topic, schemaId, messageEncoding: "cdr", metadata: new Map() }));
    }
    const time = BigInt(Math.round((start + t) * 1e6)) * 1000n;
    await writer.addMessage({ channelId: channels.get(topic), sequence: 0, logTime: time, publishTime: time, data: bytes });
  }
  await writer.end();
  fs.mkdirSync(path.dirname(path.join(folder, name)), { recursive: true });
  fs.writeFileSync(path.join(folder, name), Buffer.concat(file.parts));
}

function writeSqlite(name, chosen) {
  const file = path.join(folder, name);
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.rmSync(file, { force: true });
  const topics = [...new Map(chosen.map((m) => [m.topic, m.type]))];
  const sql = [
    "PRAGMA page_size = 1024;",
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);",
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB NOT NULL);",
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);",
    ...topics.map(([topic, type], i) => `INSERT INTO topics VALUES(${i + 1}, '${topic}', '${type.replace("/", "/msg/")}', 'cdr', '');`),
    ...chosen.map(({ t, topic, bytes }) => {
      const id = topics.findIndex(([known]) => known === topic) + 1;
      return `INSERT INTO messages(topic_id, timestamp, data) VALUES(${id}, ${BigInt(Math.round((start + t) * 1e6)) * 1000n}, X'${Buffer.from(bytes).toString("hex")}');`;
    }),
  ];
  execFileSync("sqlite3", [file], { input: sql.join("\n") });
}

function metadata(files, mode) {
  return `rosbag2_bagfile_information:
  version: 5
  storage_identifier: sqlite3
  relative_file_paths:
${files.map((name) => `    - ${name}`).join("\n")}
  compression_format: "${mode ? "zstd" : ""}"
  compression_mode: "${mode}"
`;
}

/** One message of every type, in each storage, and alone behind its type and definition. */
async function writeFuzzSeeds(all) {
  const seeds = path.join("..", "..", "fuzz", "corpus");
  const first = [...new Map([...all].reverse().map((m) => [m.topic, m])).values()].reverse().filter(({ topic }) => topic !== "/scan");
  await writeMcap(path.join(seeds, "mcap", "plain.mcap"), { useChunks: false }, first);
  for (const [name, compress] of [["zstd", zstd], ["lz4", lz4]])
    await writeMcap(path.join(seeds, "mcap", name + ".mcap"), { compressChunk: (data) => ({ compression: name, compressedData: compress(data) }) }, first.slice(0, 6));
  fs.mkdirSync(path.join(folder, seeds, "cdr"), { recursive: true });
  for (const { type, bytes } of first) {
    const file = path.join(folder, seeds, "cdr", type.split("/")[1] + ".bin");
    fs.writeFileSync(file, Buffer.concat([Buffer.from(type + "\n" + definitionOf(type) + "\0"), Buffer.from(bytes)]));
  }
  const scanType = "sensor_msgs/LaserScan";
  const small = { ...scan(0.5), ranges: [1, 2, 3], intensities: [1, 1000, 1] };
  fs.writeFileSync(path.join(folder, seeds, "cdr", "LaserScan.bin"),
    Buffer.concat([Buffer.from(scanType + "\n\0"), Buffer.from(encode(scanType, small))]));
  writeSqlite(path.join(seeds, "db3", "small.db3"), first);
}

/** The same pose in both orders of bytes. */
function writeEndianSamples() {
  for (const [name, kind] of [["little", EncapsulationKind.CDR_LE], ["big", EncapsulationKind.CDR_BE]]) {
    const writer = new CdrWriter({ kind });
    writer.int32(17).uint32(500000000).string("map");
    for (const value of [1.5, -2.5, 0.25, 0, 0, 0, 1]) writer.float64(value);
    fs.writeFileSync(path.join(folder, `pose_${name}_endian.cdr`), writer.data);
  }
}

const piped = (program, args) => (data) => execFileSync(program, args, { input: Buffer.from(data) });
const zstd = piped("zstd", ["-q", "-19", "-c"]), lz4 = piped("lz4", ["-q", "-9", "-c"]);

async function main() {
  const all = messages().map((m) => ({ ...m, bytes: encode(m.type, m.message) }));
  await writeMcap("drive_zstd.mcap", { chunkSize: 20000, compressChunk: (data) => ({ compression: "zstd", compressedData: zstd(data) }) }, all);
  await writeMcap("drive_lz4.mcap", { chunkSize: 20000, compressChunk: (data) => ({ compression: "lz4", compressedData: lz4(data) }) }, all, foxgloveDefinitionOf);
  // Nothing but the messages: no chunks, no index, no summary.
  const short = all.filter(({ topic }) => ["/tf_static", "/odom", "/nav350/landmarks", "/ground_truth/pose"].includes(topic));
  await writeMcap("plain.mcap", { useChunks: false, useStatistics: false, useSummaryOffsets: false, repeatSchemas: false, repeatChannels: false }, short);

  // Two files of sqlite3 with metadata, the definitions are those that the reader knows.
  writeSqlite("two_files/drive_0.db3", all.filter(({ t }) => t < 2.6));
  writeSqlite("two_files/drive_1.db3", all.filter(({ t }) => t >= 2.6));
  fs.writeFileSync(path.join(folder, "two_files/metadata.yaml"), metadata(["drive_0.db3", "drive_1.db3"], ""));
  for (const file of ["drive_0.db3", "drive_1.db3"]) {
    execFileSync("zstd", ["-q", "-19", "-f", "--rm", path.join(folder, "two_files", file), "-o", path.join(folder, "two_files", file + ".zstd")]);
  }
  fs.writeFileSync(path.join(folder, "two_files/metadata.yaml"), metadata(["drive_0.db3.zstd", "drive_1.db3.zstd"], "FILE"));
  // One file, every message compressed by itself.
  writeSqlite("packed_messages/drive.db3", short.map((m) => ({ ...m, bytes: zstd(m.bytes) })));
  fs.writeFileSync(path.join(folder, "packed_messages/metadata.yaml"), metadata(["drive.db3"], "MESSAGE"));
  writeSqlite("plain.db3", short.filter(({ t }) => t < 1));

  writeEndianSamples();
  await writeFuzzSeeds(all);
  fs.writeFileSync(path.join(folder, "landmarks.csv"),
    "id,x,y,z,category\n" + posts.map(({ id, p }) => `${id},${p.join(",")},post\n`).join(""));
}

main();

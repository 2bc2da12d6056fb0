# SPDX-License-Identifier: MIT
# Shows frames of shd. With SHD_PICTURE in the environment it draws three frames, prints the hash of each, writes the
# last one to that path as a PNG file, and ends.
extends Sprite

const WIDTH = 512
const HEIGHT = 288
const TEST_FRAMES = 3

var view = preload("res://shd_view.gdns").new()
var image = Image.new()
var picture = OS.get_environment("SHD_PICTURE")
var tick = 0

func _ready():
	if picture != "":
		check_refusals()
	var problem = view.open(WIDTH, HEIGHT)
	if problem != "":
		push_error(problem)
		OS.exit_code = 1
		get_tree().quit()
		set_process(false)

func _process(_delta):
	tick += 1
	image.create_from_data(WIDTH, HEIGHT, false, Image.FORMAT_RGBA8, view.draw(tick))
	if picture == "":
		show_image()
		return
	print("frame %d %s" % [tick, hash_bytes(image.get_data())])
	if tick == TEST_FRAMES:
		if image.save_png(picture) != OK:
			OS.exit_code = 1
		get_tree().quit()

func show_image():
	if texture == null:
		texture = ImageTexture.new()
		texture.create_from_image(image)
	else:
		texture.set_data(image)

# Bad calls give an error and no frame.
func check_refusals():
	var refusals = [view.draw(1).size() == 0, view.open(0, 4) != "", view.open(4) != "", view.open("4", 4) != "",
			view.open(4, 100000) != "", view.open(8, 8) == "", view.draw("1").size() == 0, view.draw(1).size() == 256]
	print("refusals %d of %d" % [refusals.count(true), refusals.size()])

# FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte. Integers of GDScript have a sign and wrap around.
func hash_bytes(bytes):
	var value = -3750763034362895579  # 0xcbf29ce484222325
	for byte in bytes:
		value = (value ^ byte) * 0x100000001b3
	return "%08x%08x" % [(value >> 32) & 0xffffffff, value & 0xffffffff]

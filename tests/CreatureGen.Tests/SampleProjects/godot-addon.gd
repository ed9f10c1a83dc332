# The add-on for Godot 4 in the words of Godot 3: what its CreatureMeshes and CreatureNode hand to the engine, which the test wrote beside this script, goes the same way here.
# Godot draws nothing without a window, so its vertices are moved as its shader moves them: by what mesh, skin and skeleton have in them then.
extends SceneTree

func _initialize():
	var file = File.new()
	file.open("res://creature.json", File.READ)
	var given = JSON.parse(file.get_as_text()).result
	var skeleton = bones(given)
	get_root().add_child(skeleton)
	var body = MeshInstance.new()
	body.mesh = surface(given)
	body.skin = binds(given)
	skeleton.add_child(body)
	body.skeleton = body.get_path_to(skeleton)
	body.material_override = coat()
	print("@rest ", farthest(body, skeleton, threes(given.vertices)))
	pose(skeleton, given)
	print("@drawn ", farthest(body, skeleton, threes(given.expected)))
	kept(body.mesh.surface_get_arrays(0), given)
	print("@volume ", volume(body.mesh.surface_get_arrays(0)))
	print("@end")
	quit()

# CreatureMeshes.Bones
func bones(given):
	var skeleton = Skeleton.new()
	for i in given.names.size():
		skeleton.add_bone(given.names[i])
		skeleton.set_bone_parent(i, given.parents[i])
		skeleton.set_bone_rest(i, transform(given.rests, i))
	return skeleton

# CreatureMeshes.Binds
func binds(given):
	var skin = Skin.new()
	for i in given.names.size():
		skin.add_bind(i, transform(given.binds, i))
	return skin

# CreatureMeshes.Surface
func surface(given):
	var arrays = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = threes(given.vertices)
	arrays[Mesh.ARRAY_NORMAL] = threes(given.normals)
	arrays[Mesh.ARRAY_TEX_UV] = twos(given.texcoords)
	arrays[Mesh.ARRAY_COLOR] = colours(given.colours)
	arrays[Mesh.ARRAY_BONES] = PoolIntArray(given.bones)
	arrays[Mesh.ARRAY_WEIGHTS] = PoolRealArray(given.weights)
	arrays[Mesh.ARRAY_INDEX] = PoolIntArray(given.indices)
	var mesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh

# CreatureMeshes.Coat, but for the atlas
func coat():
	var material = SpatialMaterial.new()
	material.vertex_color_use_as_albedo = true
	material.roughness = 0.7
	material.params_cull_mode = SpatialMaterial.CULL_DISABLED
	return material

# CreatureNode.Pose. Poses of bones are whole in Godot 4; in Godot 3 they come on top of the rest.
func pose(skeleton, given):
	for i in given.names.size():
		skeleton.set_bone_pose(i, skeleton.get_bone_rest(i).affine_inverse() * transform(given.poses, i))

# The greatest distance of any vertex from where it is expected, for what is drawn.
func farthest(body, skeleton, expected):
	var arrays = body.mesh.surface_get_arrays(0)
	var vertices = arrays[Mesh.ARRAY_VERTEX]
	var joints = arrays[Mesh.ARRAY_BONES]
	var weights = arrays[Mesh.ARRAY_WEIGHTS]
	var matrices = []
	for i in body.skin.get_bind_count():
		matrices.append(skeleton.get_bone_global_pose(body.skin.get_bind_bone(i)) * body.skin.get_bind_pose(i))
	var worst = 0.0
	for i in vertices.size():
		var drawn = Vector3()
		for k in 4:
			drawn += matrices[joints[4 * i + k]].xform(vertices[i]) * weights[4 * i + k]
		worst = max(worst, drawn.distance_to(expected[i]))
	return worst

# What the engine has of what it was given.
func kept(arrays, given):
	var colour = 0.0
	var texel = 0.0
	for i in arrays[Mesh.ARRAY_VERTEX].size():
		var c = arrays[Mesh.ARRAY_COLOR][i]
		var t = arrays[Mesh.ARRAY_TEX_UV][i]
		colour = max(colour, max(abs(c.r - given.colours[3 * i]), max(abs(c.g - given.colours[3 * i + 1]), abs(c.b - given.colours[3 * i + 2]))))
		texel = max(texel, max(abs(t.x - given.texcoords[2 * i]), abs(t.y - given.texcoords[2 * i + 1])))
	print("@count ", arrays[Mesh.ARRAY_VERTEX].size(), " ", arrays[Mesh.ARRAY_INDEX].size())
	print("@colour ", colour)
	print("@texel ", texel)

# Corners go clockwise, seen from outside: what is inside counts as positive.
func volume(arrays):
	var sum = 0.0
	var vertices = arrays[Mesh.ARRAY_VERTEX]
	var corners = arrays[Mesh.ARRAY_INDEX]
	for i in range(0, corners.size(), 3):
		sum -= vertices[corners[i]].dot(vertices[corners[i + 1]].cross(vertices[corners[i + 2]])) / 6
	return sum

func transform(numbers, i):
	var at = 12 * i
	return Transform(three(numbers, at), three(numbers, at + 3), three(numbers, at + 6), three(numbers, at + 9))

func three(numbers, at):
	return Vector3(numbers[at], numbers[at + 1], numbers[at + 2])

func threes(numbers):
	var all = PoolVector3Array()
	for i in range(0, numbers.size(), 3):
		all.append(three(numbers, i))
	return all

func twos(numbers):
	var all = PoolVector2Array()
	for i in range(0, numbers.size(), 2):
		all.append(Vector2(numbers[i], numbers[i + 1]))
	return all

func colours(numbers):
	var all = PoolColorArray()
	for i in range(0, numbers.size(), 3):
		all.append(Color(numbers[i], numbers[i + 1], numbers[i + 2]))
	return all

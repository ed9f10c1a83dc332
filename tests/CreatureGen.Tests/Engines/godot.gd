# Builds a creature from the buffers that the test wrote beside this script and says what Godot makes of them.
extends SceneTree

func _initialize():
	var file = File.new()
	file.open("res://creature.json", File.READ)
	var given = JSON.parse(file.get_as_text()).result
	var arrays = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = threes(given.positions)
	arrays[Mesh.ARRAY_NORMAL] = threes(given.normals)
	arrays[Mesh.ARRAY_TANGENT] = PoolRealArray(given.tangents)
	arrays[Mesh.ARRAY_TEX_UV] = twos(given.texcoords)
	arrays[Mesh.ARRAY_BONES] = PoolIntArray(given.joints)
	arrays[Mesh.ARRAY_WEIGHTS] = PoolRealArray(given.weights)
	arrays[Mesh.ARRAY_INDEX] = PoolIntArray(given.indices)
	var mesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	print("@triangles ", mesh.surface_get_array_index_len(0) / 3)
	normals(mesh, arrays)
	tangents(mesh)
	skeleton(given)
	print("@end")
	quit()

# Godot works out normals from the order of corners: those of front faces look at who sees them.
func normals(mesh, arrays):
	var tool = SurfaceTool.new()
	tool.create_from(mesh, 0)
	tool.generate_normals()
	var made = tool.commit_to_arrays()
	var alike = 0
	var count = 0
	var corner = made[Mesh.ARRAY_INDEX] if made[Mesh.ARRAY_INDEX] else range(made[Mesh.ARRAY_VERTEX].size())
	for i in range(0, arrays[Mesh.ARRAY_INDEX].size()):
		count += 1
		if made[Mesh.ARRAY_NORMAL][corner[i]].dot(arrays[Mesh.ARRAY_NORMAL][arrays[Mesh.ARRAY_INDEX][i]]) > 0:
			alike += 1
	print("@normals ", alike, " ", count)

# Godot works out tangents from texture coordinates by its own means.
func tangents(mesh):
	var builder = SurfaceTool.new()
	builder.create_from(mesh, 0)
	builder.generate_tangents()
	var made = builder.commit_to_arrays()
	var given = mesh.surface_get_arrays(0)
	var along = 0
	var sides = 0
	var count = 0
	var theirs = made[Mesh.ARRAY_INDEX] if made[Mesh.ARRAY_INDEX] else range(made[Mesh.ARRAY_VERTEX].size())
	for i in range(0, given[Mesh.ARRAY_INDEX].size()):
		var a = 4 * theirs[i]
		var b = 4 * given[Mesh.ARRAY_INDEX][i]
		var s = made[Mesh.ARRAY_TANGENT]
		var t = given[Mesh.ARRAY_TANGENT]
		if not has_texels(given, i - i % 3):
			continue
		count += 1
		if s[a] * t[b] + s[a + 1] * t[b + 1] + s[a + 2] * t[b + 2] > 0.7:
			along += 1
		if s[a + 3] * t[b + 3] > 0:
			sides += 1
	print("@tangents ", along, " ", sides, " ", count)

# Eyes, claws and hair lie on one texel each: their tangents have no direction of their own.
func has_texels(given, first):
	var corners = given[Mesh.ARRAY_INDEX]
	var texels = given[Mesh.ARRAY_TEX_UV]
	var p = texels[corners[first]]
	return abs((texels[corners[first + 1]] - p).cross(texels[corners[first + 2]] - p)) > 1e-9

# The rest pose of Godot's skeleton, times the bind matrices, moves nothing; a turn of one bone is the turn that was meant.
func skeleton(given):
	var bones = Skeleton.new()
	get_root().add_child(bones)
	for i in given.names.size():
		bones.add_bone(given.names[i])
		if given.parents[i] >= 0:
			bones.set_bone_parent(i, given.parents[i])
		bones.set_bone_rest(i, place(given.rotations, given.places, i))
	var farthest = 0.0
	for i in given.names.size():
		var moved = bones.get_bone_global_pose(i) * matrix(given.binds, i)
		farthest = max(farthest, moved.origin.length())
		farthest = max(farthest, (moved.basis.x - Vector3.RIGHT).length() + (moved.basis.y - Vector3.UP).length() + (moved.basis.z - Vector3.BACK).length())
	print("@rest ", farthest)

func place(rotations, places, i):
	return Transform(Basis(Quat(rotations[4 * i], rotations[4 * i + 1], rotations[4 * i + 2], rotations[4 * i + 3])), Vector3(places[3 * i], places[3 * i + 1], places[3 * i + 2]))

func matrix(m, i):
	var at = 16 * i
	return Transform(Vector3(m[at], m[at + 1], m[at + 2]), Vector3(m[at + 4], m[at + 5], m[at + 6]), Vector3(m[at + 8], m[at + 9], m[at + 10]), Vector3(m[at + 12], m[at + 13], m[at + 14]))

func threes(numbers):
	var all = PoolVector3Array()
	for i in range(0, numbers.size(), 3):
		all.append(Vector3(numbers[i], numbers[i + 1], numbers[i + 2]))
	return all

func twos(numbers):
	var all = PoolVector2Array()
	for i in range(0, numbers.size(), 2):
		all.append(Vector2(numbers[i], numbers[i + 1]))
	return all

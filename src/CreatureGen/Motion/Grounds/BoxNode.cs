using System.Numerics;

namespace CreatureGen.Motion.Grounds;

/// <summary>A box of a <see cref="BoxTree"/>: with two children, of which the first follows it in the list, or with triangles.</summary>
/// <param name="Min">Corner of the box.</param>
/// <param name="Max">Opposite corner.</param>
/// <param name="First">Second child, or first triangle of a leaf.</param>
/// <param name="Count">Number of triangles of a leaf; 0 for a box with children.</param>
internal readonly record struct BoxNode(Vector3 Min, Vector3 Max, int First, int Count);

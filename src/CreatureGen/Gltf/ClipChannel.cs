using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Gltf;

/// <summary>A joint's rotation or position in an animation.</summary>
/// <param name="Joint">Its number.</param>
/// <param name="Path"><c>rotation</c> or <c>translation</c>.</param>
/// <param name="Times">Of the keys.</param>
/// <param name="Values">Of the keys.</param>
/// <param name="Interpolation">From key to key.</param>
internal readonly record struct ClipChannel(int Joint, string Path, Accessor Times, Accessor Values, KeyInterpolation Interpolation);

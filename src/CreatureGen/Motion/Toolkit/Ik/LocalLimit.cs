using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>
/// The limit of a joint with its rest, as the joints of a frame are held against them one after the other: side by side in a list or in a leg. A <see cref="Joint"/> and its limit are objects of their own,
/// each of which a crowd fetches from memory anew: that took as long as the test.
/// </summary>
internal readonly struct LocalLimit
{
    private readonly SwingTwistBounds bounds;
    private readonly Quaternion toRest;
    private readonly bool isAlongY;
    private readonly Joint joint;

    /// <summary>That of a joint.</summary>
    public LocalLimit(Joint joint)
    {
        this.joint = joint;
        bounds = new SwingTwistBounds(joint.Limit);
        toRest = Rotation.Inverse(joint.LocalRotation);
        isAlongY = BoneAxes.AreOwn(joint);
    }

    /// <inheritdoc cref="SwingTwistLimit.ClampLocal"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion Clamp(Quaternion local) => isAlongY && bounds.Hold(Rotation.Multiply(toRest, local)) ? local : SwingTwistLimit.ClampNear(local, joint);
}

using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Winged;

/// <summary>How a left wing lies when it is folded, in angles about the body, radians, and a length.</summary>
/// <param name="Drop">Of the upper arm below level.</param>
/// <param name="Spread">Of the upper arm away from straight back, to the left.</param>
/// <param name="Rise">Of what follows above level.</param>
/// <param name="Converge">Of what follows from straight back towards the midline.</param>
/// <param name="Curl">By how much more each bone beyond the forearm turns towards the midline than the one before it.</param>
/// <param name="Lift">By how much more each of these rises than the one before it.</param>
/// <param name="Lean">Of the blade from upright towards lying flat, its trailing edge over the back; of one that hangs towards the body.</param>
/// <param name="Wrap">By how much more the blade leans at each bone beyond the upper arm: it winds about the body.</param>
/// <param name="Length">Share of their length that upper arm, forearm and hand keep: feathers slide over one another, and skin draws together.</param>
internal readonly record struct WingFold(double Drop, double Spread, double Rise, double Converge, double Curl, double Lift, double Lean, double Wrap, double Length)
{
    /// <summary>Number of what can be chosen.</summary>
    public const int Count = 9;

    /// <summary>Whether the bones hang, rather than lie back: then what goes aside is told from the plane of the midline, and the blade leans about its bone, so that both mean something of a bone that points down.</summary>
    public bool Hangs { get; init; }

    /// <summary>The same with one number changed, within its bounds.</summary>
    public WingFold With(int number, double change, in WingFold min, in WingFold max) => number switch
    {
        0 => this with { Drop = Scalar.Clamp(Drop + change, min.Drop, max.Drop) },
        1 => this with { Spread = Scalar.Clamp(Spread + change, min.Spread, max.Spread) },
        2 => this with { Rise = Scalar.Clamp(Rise + change, min.Rise, max.Rise) },
        3 => this with { Converge = Scalar.Clamp(Converge + change, min.Converge, max.Converge) },
        4 => this with { Curl = Scalar.Clamp(Curl + change, min.Curl, max.Curl) },
        5 => this with { Lift = Scalar.Clamp(Lift + change, min.Lift, max.Lift) },
        6 => this with { Lean = Scalar.Clamp(Lean + change, min.Lean, max.Lean) },
        7 => this with { Wrap = Scalar.Clamp(Wrap + change, min.Wrap, max.Wrap) },
        _ => this with { Length = Scalar.Clamp(Length + change, min.Length, max.Length) },
    };

    /// <summary>Direction of a bone, unit.</summary>
    public Vector3 Direction(int bone)
    {
        double up = bone == 0 ? -Drop : Rise + ((bone - 1) * Lift);
        double aside = bone == 0 ? Spread : -Converge - ((bone - 1) * Curl);
        PortableMath.SinCos(up, out double su, out double cu);
        PortableMath.SinCos(aside, out double sa, out double ca);
        return Hangs ? new Vector3((float)sa, (float)(su * ca), (float)(-ca * cu)) : new Vector3((float)(sa * cu), (float)su, (float)(-ca * cu));
    }

    /// <summary>How much the leading edge bends in the plane of the blade: squares of the angles from bone to bone.</summary>
    public double Corners => ((Drop + Rise) * (Drop + Rise)) + (2 * Lift * Lift);

    /// <summary>The side to which the upper face of the wing looks at a bone.</summary>
    public Vector3 Face(int bone)
    {
        PortableMath.SinCos(Lean + (bone * Wrap), out double sine, out double cosine);
        Vector3 along = Hangs ? Direction(bone) : -Vector3.UnitZ;
        return new Vector3((float)cosine, -along.Z * (float)sine, along.Y * (float)sine);
    }
}

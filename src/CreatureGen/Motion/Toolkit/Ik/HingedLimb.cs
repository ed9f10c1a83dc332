using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>
/// Two rigid parts joined by a hinge, turned and bent so that their end comes to a target: the closed form under <see cref="TwoBoneIk"/> and <see cref="PantographIk"/>.
/// </summary>
/// <remarks>
/// <para>a and b are the parts, h the hinge, o = h · (a + b) what of them lies along it, A and B what lies across. With the wanted distance d, d² − o² = A² + B² + 2AB cos γ gives the bend γ ≥ 0 of b
/// about h. Then one rotation takes the chord a + R(h, γ − γ₀) b onto the target and h as near as it can to the wanted side. The middle turns about its hinge and about nothing else, so
/// it is never twisted, and the parts need not be at right angles to the hinge. Angles enter by their half-angle sines and cosines alone: no inverse cosine, whose argument rounding may push beyond 1.</para>
/// <para>Vectors come by reference: by value they come in pairs of registers that are put together by way of memory, which takes a fifth of the time where the compiler has no profile to write the method out where it is called.</para>
/// </remarks>
internal static class HingedLimb
{
    private const double ReachedFraction = 1e-4;

    /// <summary>Solves for the turns that take each part from where it is to where it has to be.</summary>
    /// <param name="upper">First part, from the root to the hinge, metres.</param>
    /// <param name="lower">Second part, from the hinge to the end, metres.</param>
    /// <param name="hinge">Unit axis about which the second part turns as the limb folds.</param>
    /// <param name="target">Where the end has to be, from the root, metres.</param>
    /// <param name="side">Where the hinge has to point; its part along the target does not matter.</param>
    /// <param name="reach">How far the limb stretches and folds.</param>
    /// <param name="upperTurn">Turns the first part.</param>
    /// <param name="lowerTurn">Turns the second part.</param>
    /// <exception cref="ArgumentException">A part has no length across the hinge.</exception>
    public static IkResult Solve(in Vector3 upper, in Vector3 lower, in Vector3 hinge, in Vector3 target, in Vector3 side, in Reach reach, out Quaternion upperTurn, out Quaternion lowerTurn)
    {
        float alongUpper = Vec.Dot(upper, hinge);
        float alongLower = Vec.Dot(lower, hinge);
        Vector3 a = upper - (hinge * alongUpper);
        Vector3 b = lower - (hinge * alongLower);
        double lengthA = Math.Sqrt(Vec.LengthSquared(a));
        double lengthB = Math.Sqrt(Vec.LengthSquared(b));
        double product = lengthA * lengthB;
        if (!(product > 1e-14))
        {
            throw new ArgumentException(FormattableString.Invariant($"parts of {lengthA} m and {lengthB} m across their hinge; expected more than none"));
        }

        double offset = (double)alongUpper + alongLower;
        double squared = Vec.LengthSquared(target);
        double asked = Math.Sqrt(squared);
        double inPlane = Math.Sqrt(Math.Max(0, squared - (offset * offset)));
        double taken = reach.Limit(inPlane, lengthA, lengthB, out IkStatus status);

        // Bend now and bend wanted, as cosine and sine about the hinge.
        double cosNow = Vec.Dot(a, b) / product;
        double sinNow = Vec.Dot(Vec.Cross(a, b), hinge) / product;
        double cosThen = Scalar.Clamp(((taken * taken) - (lengthA * lengthA) - (lengthB * lengthB)) / (2 * product), -1, 1);
        double sinThen = Math.Sqrt((1 - cosThen) * (1 + cosThen));
        HalfAngle.Of((cosThen * cosNow) + (sinThen * sinNow), (sinThen * cosNow) - (cosThen * sinNow), out double halfCos, out double halfSin);
        var bend = new Quaternion((float)(hinge.X * halfSin), (float)(hinge.Y * halfSin), (float)(hinge.Z * halfSin), (float)halfCos);

        Vector3 chord = upper + Rotation.Rotate(bend, lower);
        Vector3 along = asked > 1e-6 * (lengthA + lengthB) ? target / (float)asked : Vec.Normalize(upper + lower, Vec.Normalize(upper));
        float chordLength = Vec.Length(chord);
        Vector3 chordAlong = chordLength > 1e-6f * (float)(lengthA + lengthB) ? chord / chordLength : Vec.Perpendicular(hinge);
        upperTurn = UnitRotation.Frame(chordAlong, hinge, along, side);
        lowerTurn = Rotation.Multiply(upperTurn, bend);
        double residual = Math.Abs(asked - Math.Sqrt((taken * taken) + (offset * offset)));
        if (residual <= ReachedFraction * (lengthA + lengthB))
        {
            status = IkStatus.Reached;
        }
        else if (status == IkStatus.Reached)
        {
            status = IkStatus.TooNear;
        }

        return new IkResult(status, (float)residual);
    }
}

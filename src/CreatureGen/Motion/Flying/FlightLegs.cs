using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>A pair of legs or arms of a flier: tucked, hanging or reaching for the ground in the air, and planted on it while the body crouches.</summary>
internal sealed class FlightLegs
{
    private const int Hip = 1;
    private const int Ankle = 3;
    private const double FullReach = 0.995;
    private const double Dangle = 0.05;

    /// <summary>How far thighs that lie out to the side go up as they are swept back, parts of that: insects draw their knees up to the body, sprawlers let them hang.</summary>
    private const double RaisedKnees = 0.25;
    private const double LoweredKnees = -0.5;

    /// <summary>How much of the fan in which several pairs are held at cruise is left where they hang.</summary>
    private const double FannedHanging = 0.5;

    /// <summary>Share below which a leg is in the air alone.</summary>
    private const double MinPlanted = 1e-5;

    private readonly PairedChain chain;
    private readonly LegPosture tucked;
    private readonly LegPosture hanging;
    private readonly LegPosture reaching;
    private readonly bool lateral;
    private readonly double raise;
    private readonly Vector3 femur;
    private readonly Vector3 normal;
    private readonly double side;

    /// <param name="chain">The pair.</param>
    /// <param name="place">Its place among several pairs of its kind, from 0 for the first to 1 for the last; null for the only one.</param>
    public FlightLegs(PairedChain chain, double? place)
    {
        this.chain = chain;
        LimbArchetype archetype = chain.Limb.Archetype ?? LimbArchetype.Arm;
        LegKind kind = LegKinds.Of(archetype);
        LegFlight flight = kind.Flight;

        // What is built as it trails is held so already.
        bool trails = kind.Trailing != null && !chain.Limb.Stands;
        (tucked, hanging, reaching) = trails ? default : (flight.Tucked, flight.Hanging, flight.Reaching);
        if (place != null && !trails)
        {
            tucked = flight.InRow(place.Value);
            hanging = LegPosture.Between(hanging, tucked, FannedHanging);
        }

        lateral = kind.Outline.Lateral;
        raise = kind.Outline.Arched ? RaisedKnees : LoweredKnees;
        Vector3 thigh = chain.Points[2] - chain.Points[1];
        Vector3 shank = chain.Points[3] - chain.Points[2];
        femur = Vec.Normalize(thigh, Vector3.UnitX);
        normal = Vec.Normalize(Vec.Cross(thigh, shank), Vector3.UnitX);
        Vector3 line = Vec.Normalize(thigh + shank, -Vector3.UnitY);
        side = Vec.Dot(thigh, Vec.Cross(normal, line)) < 0 ? -1 : 1;
    }

    /// <summary>Whether it is one to stand on.</summary>
    public bool Stands => chain.Limb.Kind == LimbKind.Leg;

    /// <summary>Height of its sole at rest, model space, metres.</summary>
    public double Sole => chain.Limb.Contact.Y;

    /// <summary>From the hip to the sole at rest, metres.</summary>
    public double Length => chain.Points[Hip].Y - Sole;

    /// <summary>Writes the joints of both sides.</summary>
    /// <param name="local">Receives them.</param>
    /// <param name="stroke">The moment.</param>
    /// <param name="body">Turn of the body in the root's axes.</param>
    /// <param name="bodyPivot">The body's root at rest.</param>
    /// <param name="bodyNow">The body's root now, in the root's axes.</param>
    public void Write(in Pose local, in LegStroke stroke, Quaternion body, Vector3 bodyPivot, Vector3 bodyNow)
    {
        LegPosture posture = LegPosture.Between(LegPosture.Between(tucked, hanging, stroke.Hanging), reaching, stroke.Reaching);
        Span<Quaternion> turns = stackalloc Quaternion[5];
        double dangle = Dangle * stroke.Swing;
        turns[0] = Quaternion.Identity;
        turns[1] = Bend(posture.Hip + dangle, posture.Twist);
        turns[2] = lateral ? Rotation.FromAxisAngle(normal, -posture.Knee) : AxisRotation.Pitch(posture.Knee);
        turns[3] = lateral ? Rotation.FromAxisAngle(normal, 0.5 * posture.Ankle) : AxisRotation.Pitch(posture.Ankle + dangle);
        turns[4] = lateral ? Rotation.FromAxisAngle(normal, 0.5 * posture.Ball) : AxisRotation.Pitch(posture.Ball);
        bool plants = Stands && stroke.Planted > MinPlanted;
        if (plants)
        {
            Plant(turns, stroke, body, bodyPivot, bodyNow);
        }

        for (int k = 0; k < chain.Count && k < turns.Length; k++)
        {
            // Hips and knees that put the foot where it will stand do so; all else slows down towards its limits.
            if (plants && k < Ankle)
            {
                chain.WriteFirm(local, k, Rotation.Slerp(chain.Limit(k, turns[k]), turns[k], stroke.Planted));
            }
            else
            {
                chain.Write(local, Side.Left, k, turns[k]);
                chain.Write(local, Side.Right, k, turns[k]);
            }
        }
    }

    private Quaternion Bend(double hip, double twist) => lateral ? Rotation.Multiply(AxisRotation.Roll(raise * Math.Abs(hip)), Rotation.Multiply(AxisRotation.Yaw(hip), Rotation.FromAxisAngle(femur, twist))) : AxisRotation.Pitch(hip);

    /// <summary>Two bones reach from the hip, wherever the body has taken it, to the ankle's place over the foothold; the foot stays level.</summary>
    private void Plant(Span<Quaternion> turns, in LegStroke stroke, Quaternion body, Vector3 bodyPivot, Vector3 bodyNow)
    {
        Vector3 hip = bodyNow + Rotation.Rotate(body, chain.Points[Hip] - bodyPivot);
        Vector3 ankle = chain.Points[Ankle] - new Vector3(0f, (float)(Sole + stroke.Height), 0f);
        Vector3 thigh = chain.Points[2] - chain.Points[1];
        Vector3 shank = chain.Points[3] - chain.Points[2];
        double a = Vec.Length(thigh);
        double b = Vec.Length(shank);
        Vector3 way = ankle - hip;
        double far = Vec.Length(way);
        double d = Scalar.Clamp(far, Math.Abs(a - b) + (1e-3 * (a + b)), FullReach * (a + b));
        Vector3 line = Vec.Normalize(way, -Vector3.UnitY);
        Vector3 across = Vec.Normalize(Vec.Reject(normal, line), Vector3.UnitX);
        Vector3 bow = Vec.Cross(across, line) * (float)side;
        double along = ((a * a) - (b * b) + (d * d)) / (2 * d);
        double bowed = Math.Sqrt(Math.Max(0, (a * a) - (along * along)));
        Vector3 knee = (line * (float)along) + (bow * (float)bowed);
        Quaternion upper = Aim(thigh, knee, across);
        Quaternion lower = Aim(shank, (line * (float)d) - knee, across);
        double fraction = stroke.Planted;
        turns[1] = Rotation.Slerp(turns[1], Rotation.Multiply(Rotation.Inverse(body), upper), fraction);
        turns[2] = Rotation.Slerp(turns[2], Rotation.Multiply(Rotation.Inverse(upper), lower), fraction);
        turns[3] = Rotation.Slerp(turns[3], Rotation.Inverse(lower), fraction);
        turns[4] = Rotation.Slerp(turns[4], Quaternion.Identity, fraction);
    }

    /// <summary>The turn that takes a bone of the rest pose to a direction, with the plane of the leg's bend staying one.</summary>
    private Quaternion Aim(Vector3 rest, Vector3 direction, Vector3 across)
    {
        Vector3 y0 = Vec.Normalize(rest, -Vector3.UnitY);
        Vector3 x0 = Vec.Normalize(Vec.Reject(normal, y0), Vector3.UnitX);
        Vector3 y1 = Vec.Normalize(direction, -Vector3.UnitY);
        Vector3 x1 = Vec.Normalize(Vec.Reject(across, y1), Vector3.UnitX);
        Quaternion from = Rotation.FromBasis(x0, y0, Vec.Cross(x0, y0));
        Quaternion to = Rotation.FromBasis(x1, y1, Vec.Cross(x1, y1));
        return Rotation.Multiply(to, Rotation.Inverse(from));
    }
}

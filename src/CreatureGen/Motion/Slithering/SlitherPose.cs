using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Slithering;

/// <summary>Lays the bones of a crawler on its track.</summary>
internal static class SlitherPose
{
    private const int RootSamples = 24;

    /// <summary>Part of the chest's swing that the head keeps.</summary>
    private const double HeadSwing = 0.2;

    /// <summary>Part of the slope that the head takes on.</summary>
    private const double HeadTilt = 0.3;

    /// <summary>Part of what the neck can turn that it does: its joints slow down towards their limits.</summary>
    private const double NeckUse = 0.95;

    private const double SidewindLift = 0.045;

    /// <summary>Swing of the track above which the body rests in sidewinding, and how much less lifts it as high as it goes.</summary>
    private const double RestingSwing = 0.95;
    private const double LiftedSwing = 1.1;

    private const double BellyWave = 0.006;
    private const double HeadLift = 0.10;
    private const int Search = 4;

    /// <summary>Part of a bone's length by which its ends may miss it.</summary>
    private const double Near = 1e-5;

    /// <summary>Share of the belly's waves below which there are none.</summary>
    private const double MinWave = 1e-5;

    /// <summary>From the root forward to the joint of the head, which leads the track, metres.</summary>
    public static double Lead(SlitherProfile profile) => profile.Chain.Bones[0].Rear.Z;

    /// <summary>The middle of the body: the mean of the track over one wave, so that its swings cancel. Where less than half a wave of it leads up to the head, it is that of the wave behind the head, taken
    /// on along the way: there is no track yet ahead of a head.</summary>
    public static void FindMiddle(SlitherProfile profile, SlitherState state, in CrawlFloor floor)
    {
        SlitherTrack track = state.Track;
        double half = 0.5 * track.Wavelength;
        double lead = Lead(profile);
        double ahead = Math.Max(half - lead, 0);
        double middle = track.Head - Math.Max(half, lead);
        double x = 0;
        double z = 0;
        double yaw = 0;
        double near = 0;
        for (int k = 0; k < RootSamples; k++)
        {
            double arc = middle + (half * (((2.0 * k) + 1 - RootSamples) / RootSamples));
            TrackPoint point = track.At(arc);
            x += point.X / RootSamples;
            z += point.Z / RootSamples;
            near += point.Y / RootSamples;
            yaw += track.CourseAngleAt(arc) / RootSamples;
        }

        if (ahead > 0)
        {
            PortableMath.SinCos(yaw, out double sine, out double cosine);
            double way = ahead * state.Progress;
            x += way * sine;
            z += way * cosine;
        }

        state.Middle = new Vector3((float)x, (float)floor.HeightAt(x, near, z, out _), (float)z);
        state.Yaw = yaw;
    }

    /// <summary>Writes the pose.</summary>
    public static void Write(SlitherProfile profile, SlitherState state, in CrawlFloor floor, in Pose local)
    {
        AxialChain chain = profile.Chain;
        Span<Quaternion> turns = stackalloc Quaternion[chain.Count];
        Span<Vector3> pivots = stackalloc Vector3[chain.Count];
        Span<Vector3> middles = stackalloc Vector3[chain.Count];
        PortableMath.SinCos(state.Yaw, out double sine, out double cosine);
        double arc = state.Track.Head;
        Vector3 front = Place(profile, state, floor, arc, out Vector3 frontUp);
        Vector3 neckUp = Vector3.UnitY;
        for (int b = 1; b < chain.Count; b++)
        {
            double length = profile.Lengths[b];
            double behind = arc - length;
            Vector3 rear = Place(profile, state, floor, behind, out Vector3 rearUp);
            for (int k = 0; k < Search; k++)
            {
                double missing = Vec.Distance(front, rear) - length;
                if (Math.Abs(missing) < Near * length)
                {
                    break;
                }

                behind += missing;
                rear = Place(profile, state, floor, behind, out rearUp);
            }

            Vector3 up = Level(frontUp + rearUp, sine, cosine);
            turns[b] = Lie(Level(front - rear, sine, cosine), up);
            middles[b] = Level((front + rear) * 0.5f, sine, cosine) + (Vec.Normalize(up, Vector3.UnitY) * (float)profile.Heights[b]);
            neckUp = b == profile.NeckBones ? up : neckUp;
            arc = behind;
            front = rear;
            frontUp = rearUp;
        }

        Steady(profile, state, neckUp, turns);

        // The body's root lies as the axis does there, or the joints next to it would have to turn by all of it.
        Quaternion there = Rotation.Slerp(turns[chain.BeforeRoot], turns[chain.BehindRoot], 0.5);
        for (int b = 0; b < chain.Count; b++)
        {
            turns[b] = Rotation.Multiply(Rotation.Inverse(there), turns[b]);
        }

        chain.Write(local, turns, pivots);

        // It goes where it brings the bones nearest to their places.
        Vector3 shift = Vector3.Zero;
        double weight = 0;
        for (int b = profile.NeckBones; b < chain.Count; b++)
        {
            double m = profile.Lengths[b];
            shift += (middles[b] - Rotation.Rotate(there, chain.Carry(b, chain.Bones[b].Middle, turns, pivots))) * (float)m;
            weight += m;
        }

        local.Rotations[chain.Body] = UnitRotation.Renormalize(Rotation.Multiply(there, profile.Skeleton.LocalRotations[chain.Body]));
        local.Positions[chain.Body] = profile.Skeleton.LocalPositions[chain.Body] + (shift / (float)weight) - chain.BodyPivot;
    }

    /// <summary>A point of the track from the root's place, world axes, with the lift of parts that do not rest.</summary>
    private static Vector3 Place(SlitherProfile profile, SlitherState state, in CrawlFloor floor, double arc, out Vector3 up)
    {
        TrackPoint point = state.Track.At(arc);
        double height = point.Y;
        Vector3 normal = point.Normal;
        double sides = state.Sidewinding.Value;
        if (sides > 1e-4)
        {
            // A track that drifts lies on other ground than it was laid on. Where the swing is at its left end the body rests.
            double sampled = floor.HeightAt(point.X, point.Y, point.Z, out Vector3 now);
            double fade = Math.Min(1, sides * 4);
            double swing = TrackSteering.Swing(arc / state.Track.Wavelength, sides);
            height = Scalar.Lerp(height, sampled, fade) + (sides * SidewindLift * profile.Wavelength * Scalar.Smooth((RestingSwing - swing) / LiftedSwing));
            normal = Vec.Lerp(normal, now, (float)fade);
        }

        double straight = 1 - Math.Min(1, state.Winding.Value / Math.Max(profile.Alpha, 1e-3));
        if (straight > MinWave)
        {
            height += straight * BellyWave * profile.Wavelength * (1 - PortableMath.Cos(8 * PortableMath.Pi * arc / state.Track.Wavelength)) * (1 - state.Idle.Value);
        }

        up = Vec.Normalize(normal, Vector3.UnitY);
        return new Vector3((float)(point.X - state.Middle.X), (float)(height - state.Middle.Y), (float)(point.Z - state.Middle.Z));
    }

    /// <summary>World axes to the root's, from sine and cosine of its yaw.</summary>
    private static Vector3 Level(Vector3 v, double sine, double cosine) => new((float)((v.X * cosine) - (v.Z * sine)), v.Y, (float)((v.Z * cosine) + (v.X * sine)));

    /// <summary>How a bone lies that points along a direction, with its back away from the ground.</summary>
    private static Quaternion Lie(Vector3 direction, Vector3 up)
    {
        Vector3 ahead = Vec.Normalize(direction, Vector3.UnitZ);
        Vector3 left = Vec.Normalize(Vec.Cross(up, ahead), Vector3.UnitX);
        return Rotation.FromBasis(left, Vec.Cross(ahead, left), ahead);
    }

    /// <summary>The neck turns back what the chest swings, each bone by what its joint can turn, so that the head looks along the way; a crawler that lies still lifts it and looks about.</summary>
    private static void Steady(SlitherProfile profile, SlitherState state, Vector3 up, Span<Quaternion> turns)
    {
        int neck = profile.NeckBones;
        double way = state.CourseAngle - state.Yaw + Askance(profile, state);
        PortableMath.SinCos(way, out double aside, out double ahead);
        Quaternion along = Lie(Vec.Reject(new Vector3((float)aside, 0f, (float)ahead), Vec.Normalize(up, Vector3.UnitY)), up);
        double kept = HeadSwing * HeadTilt;
        for (int b = 1; b < neck; b++)
        {
            turns[b] = Rotation.Slerp(along, turns[neck], 1 - ((1 - kept) * profile.NeckFractions[b]));
        }

        turns[0] = Rotation.Slerp(along, turns[neck], HeadSwing);
        double idle = state.Idle.Value;
        PortableMath.SinCos(2 * PortableMath.Pi * state.Breath, out double sine, out double cosine);
        turns[0] = Rotation.Slerp(AxisRotation.Yaw(way), turns[0], HeadTilt);
        turns[0] = Rotation.Multiply(turns[0], Rotation.Multiply(AxisRotation.Yaw(0.12 * idle * sine), AxisRotation.Pitch((-HeadLift * idle) - (0.02 * idle * cosine))));
    }

    /// <summary>By how much the head looks aside of the way: a sidewinder lies so far across it that not every neck bends back by all of it.</summary>
    private static double Askance(SlitherProfile profile, SlitherState state)
    {
        double beyond = Math.Abs(state.Slant) + state.Winding.Value - (NeckUse * profile.NeckReach);
        return beyond <= 0 ? 0 : state.Sidewinding.Value * (state.Slant < 0 ? -beyond : beyond);
    }
}

using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Anatomy.Feet;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>The joints and radii of one left leg, laid from its socket. Model space, metres at scale 1.</summary>
internal sealed class LegPath
{
    /// <summary>Metres. Least distance of a leg's inner side from the sagittal plane.</summary>
    private const float InnerGap = 0.012f;

    /// <summary>Share of the bow of a long-toed leg, seen from the front, that is left between its thigh and its foot.</summary>
    private const float Bow = 0.25f;

    /// <summary>Share of the way from below its hip to where both feet just clear each other that the foot of a tall long-toed leg is set in.</summary>
    private const float Narrowing = 0.9f;

    /// <summary>Share of the way out from its hip to its thigh that a tall long-toed leg gives up.</summary>
    private const float Gathering = 0.8f;

    /// <summary>Share of the way from below its hip to the sagittal plane, as far as there is room, that a foot under the body of another leg is set in: straight down from the flanks four legs are those of a table from the front.</summary>
    private const float Converging = 0.25f;

    // Height of a hip in distances of the foot from the sagittal plane: from the first on a leg is tall, at the second it is fully so.
    private const float Tall = 2.8f;
    private const float Tallest = 4.2f;

    /// <summary>Metres between the toes of two feet and the sagittal plane.</summary>
    private const float FootGap = 0.02f;

    /// <summary>Least and widest splay of toes that feet are set apart for, radians; half the width of a toe's end in its radii, and how far a claw reaches to the side, in its lengths.</summary>
    private const float MinSplay = 0.2f;
    private const float WidestSplay = 0.95f;
    private const float ToeTip = 0.65f;
    private const float ClawReach = 0.5f;

    // How much less a leg in the air is laid back, and how much further it hangs, for each radian that it is turned ahead, and the most that it counts as turned.
    private const float Trailing = 2.2f;
    private const float Hanging = 0.9f;
    private const float MostSpread = 0.32f;

    /// <summary>Radians. An insect's legs that are turned back further lie along its abdomen.</summary>
    private const double LaidBack = -0.65;

    private LegPath(Vector3[] joints, Vector3[] centres, Vector2[] radii, float thickness)
    {
        Joints = joints;
        Centres = centres;
        Radii = radii;
        Thickness = thickness;
        for (int k = 1; k < joints.Length; k++)
        {
            Length += Vec.Distance(joints[k], joints[k - 1]);
        }
    }

    public Vector3[] Joints { get; }

    /// <summary>The middle of the flesh at each joint.</summary>
    public Vector3[] Centres { get; }

    /// <summary>Fore-aft and lateral radius of the flesh at each joint.</summary>
    public Vector2[] Radii { get; }

    /// <summary>Radius of the thigh after its limits.</summary>
    public float Thickness { get; }

    /// <summary>Sum of the distances between the joints.</summary>
    public float Length { get; }

    /// <summary>Lays a leg from its form and blueprint.</summary>
    public static LegPath Lay(LegForm form, LegBlueprint leg, SocketLoop socket, BodyShape shape)
    {
        bool standing = leg.Stance == LegStance.Standing;
        Vector3 root = socket.Centre;
        float height = standing ? root.Y : (float)leg.Length;
        float thickness = form.Thickness((float)leg.Thickness, socket.HalfLength, height);

        Vector3[] joints = LayJoints(form, leg, root, height);
        Vector2[] radii = Radiate(form, leg, socket, thickness);
        Vector3[] offsets = Offset(form, leg, thickness);
        if (!form.Lateral)
        {
            KeepFromMidline(form, joints, radii, offsets);
        }

        if (standing)
        {
            SetFootDown(form, leg, thickness, joints, radii);
        }

        bool laidBack = form.Arched && leg.Azimuth < LaidBack;
        if (laidBack || form.Carried || form.Crouched || (form.Lateral && !standing))
        {
            KeepJointsOut(shape, joints, radii);
        }

        var centres = new Vector3[joints.Length];
        for (int k = 0; k < joints.Length; k++)
        {
            centres[k] = joints[k] + offsets[k];
        }

        return new LegPath(joints, centres, radii, thickness);
    }

    private static Vector3[] LayJoints(LegForm form, LegBlueprint leg, Vector3 root, float height)
    {
        float reach = (float)leg.Reach;
        Vector3 outward = Vector3.UnitX;
        Vector3 ahead = Vector3.UnitZ;
        if (form.Lateral)
        {
            outward = new Vector3((float)PortableMath.Cos(leg.Azimuth), 0f, (float)PortableMath.Sin(leg.Azimuth));
            ahead = form.Sprawling ? new Vector3(0.25f, 0f, 0.97f) : Vector3.UnitZ;
        }

        // Laid back alike, the legs of an insect in the air are the teeth of a comb: the foremost hang, the hindmost trail.
        float trail = form.Arched && leg.Stance == LegStance.Hanging ? Scalar.Clamp((float)leg.Azimuth, -MostSpread, MostSpread) : 0f;
        var joints = new Vector3[form.Rows];
        for (int k = 0; k < form.Rows; k++)
        {
            float down = form.Down[k] * (form.Down[k] > 0f ? 1f + (Hanging * trail) : 1f);
            if (form.Arched && k is >= 1 and < 5)
            {
                down *= (float)leg.KneeRise;
            }

            joints[k] = root
                + (ahead * (form.Forward[k] * (1f - (Trailing * trail)) * reach))
                - (Vector3.UnitY * (down * height))
                + (outward * (form.Outward[k] * reach))
                + (Vector3.UnitZ * ((float)leg.Shear * Scalar.Clamp(form.Down[k], 0f, 1f) * height));
        }

        return joints;
    }

    private static Vector2[] Radiate(LegForm form, LegBlueprint leg, SocketLoop socket, float thickness)
    {
        var radii = new Vector2[form.Rows];
        for (int k = 0; k < form.Rows; k++)
        {
            radii[k] = new Vector2(form.ForeRadius[k], form.SideRadius[k]) * Girth(form, leg, thickness, k);
        }

        radii[0] = new Vector2(socket.HalfLength, socket.HalfWidth);
        return radii;
    }

    /// <summary>What radii and offsets of a row are multiplied by.</summary>
    private static float Girth(LegForm form, LegBlueprint leg, float thickness, int row) =>
        thickness * (float)leg.Stoutness * (row >= 2 ? (float)leg.Slimness : 1f) * (row >= form.Rows - form.FootRows ? (float)leg.FootSize : 1f);

    private static Vector3[] Offset(LegForm form, LegBlueprint leg, float thickness)
    {
        var offsets = new Vector3[form.Rows];
        for (int k = 0; k < form.Rows; k++)
        {
            offsets[k] = new Vector3(form.SideOffset[k], 0f, form.ForeOffset[k]) * Girth(form, leg, thickness, k);
        }

        return offsets;
    }

    /// <summary>Moves the bones out until the flesh that is as far outside as inside of them is on its own side; what of a thigh fills the crotch is pressed flat there as it grows.</summary>
    private static void KeepFromMidline(LegForm form, Vector3[] joints, Vector2[] radii, Vector3[] offsets)
    {
        if (form.End is FootEnd.Hoof or FootEnd.Pad)
        {
            // The shank moves out as a whole: a straight leg must not be kinked row by row.
            float shift = 0f;
            for (int k = 0; k < joints.Length; k++)
            {
                if (form.Down[k] > 0.5f)
                {
                    shift = Math.Max(shift, radii[k].Y + InnerGap - joints[k].X);
                }
            }

            for (int k = 0; k < joints.Length; k++)
            {
                joints[k].X += shift * Scalar.Smooth(form.Down[k] / 0.6f);
            }
        }

        for (int k = 1; k < joints.Length; k++)
        {
            joints[k].X = Math.Max(joints[k].X, radii[k].Y + offsets[k].X + InnerGap);
        }
    }

    /// <summary>Sets a foot of a half width in under the body.</summary>
    private static void Converge(LegForm form, Vector3[] joints, float halfWidth)
    {
        float shift = Converging * Math.Max(0f, joints[joints.Length - 1].X - halfWidth);
        for (int k = 0; k < joints.Length; k++)
        {
            joints[k].X -= shift * Scalar.Smooth(form.Down[k] / 0.9f);
        }
    }

    private static void SetFootDown(LegForm form, LegBlueprint leg, float thickness, Vector3[] joints, Vector2[] radii)
    {
        int last = joints.Length - 1;
        if (form.End == FootEnd.Toes)
        {
            bool underBody = !form.Sprawling && !form.Crouched;
            if (underBody)
            {
                FootForm foot = FootForm.Of(leg.Foot);
                float size = thickness * (float)leg.FootSize;
                float inward = (1f - Digits.TurnedOut) * form.ToeSplay;
                float beside = size * form.ToeLength * (form.LongToed ? inward : foot.Length * Math.Min(foot.Splay * form.ToeSplay, WidestSplay));
                float tip = form.LongToed || foot.Splay > 1f ? size * form.ToeRadius * (ToeTip + (ClawReach * (float)leg.ClawLength)) : 0f;
                float min = (size * form.ToeLength * (form.LongToed ? inward : MinSplay)) + FootGap;
                float halfWidth = radii[last].Y + Math.Max(min, beside + tip);
                float shift = Math.Max(0f, halfWidth - joints[last].X);
                if (form.LongToed && shift == 0f)
                {
                    // Straight down from the flanks, tall legs look like a wishbone.
                    float tall = Scalar.Smooth(((joints[0].Y / joints[last].X) - Tall) / (Tallest - Tall));
                    shift = Narrowing * tall * (halfWidth - joints[last].X);
                    joints[1].X -= Gathering * tall * Math.Max(0f, joints[1].X - joints[0].X);
                }

                for (int k = 0; k <= last; k++)
                {
                    joints[k].X += shift * Scalar.Smooth(form.Down[k] / 0.9f);
                }

                if (form.LongToed)
                {
                    Straighten(form, joints);
                }
                else
                {
                    Converge(form, joints, halfWidth);
                }
            }

            joints[last - 1].Y = radii[last - 1].X * 0.66f;
            joints[last].Y = radii[last].X * (form.LongToed ? 0.66f : 0.6f);
            if (underBody && !form.LongToed)
            {
                joints[last].Z = Math.Max(joints[last].Z, joints[last - 1].Z + (1.15f * radii[last].X));
            }
        }
        else if (form.End is FootEnd.Hoof or FootEnd.Pad)
        {
            joints[last].Y = 0f;
            Converge(form, joints, radii[last].Y + InnerGap);
        }
        else
        {
            // A narrow tip stands on its end, pressed flat a little.
            joints[last].Y = radii[last].X * 0.5f;
        }
    }

    /// <summary>Brings the joints below the thigh near the line to the foot as it is seen from the front: a tall leg that bows out and in again looks like a wishbone.</summary>
    private static void Straighten(LegForm form, Vector3[] joints)
    {
        int last = joints.Length - 1;
        for (int k = 2; k < last - 1; k++)
        {
            float fraction = (form.Down[k] - form.Down[1]) / (form.Down[last] - form.Down[1]);
            float straight = Scalar.Lerp(joints[1].X, joints[last].X, fraction);
            joints[k].X = Scalar.Lerp(straight, joints[k].X, Bow);
        }
    }

    /// <summary>Moves the joints of a free limb out of the body, each with all that follow it.</summary>
    private static void KeepJointsOut(BodyShape shape, Vector3[] joints, Vector2[] radii)
    {
        for (int k = 1; k < joints.Length; k++)
        {
            int ring = 0;
            double best = double.MaxValue;
            for (int i = 0; i < BodyGrid.Rings; i++)
            {
                double dy = shape.Y[i] - joints[k].Y;
                double dz = shape.Z[i] - joints[k].Z;
                double d = (dy * dy) + (dz * dz);
                if (d < best)
                {
                    best = d;
                    ring = i;
                }
            }

            double distance = Math.Sqrt(best);
            double extent = Math.Max(shape.Top[ring], shape.Bottom[ring]) + (radii[k].X * 0.5);
            if (distance >= extent)
            {
                continue;
            }

            double ratio = distance / extent;
            float need = (float)(shape.Width[ring] * Math.Sqrt(1 - (ratio * ratio))) + (radii[k].Y * 1.05f) + InnerGap - joints[k].X;
            for (int m = k; m < joints.Length && need > 0f; m++)
            {
                joints[m].X += need;
            }
        }
    }
}

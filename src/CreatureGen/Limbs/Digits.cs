using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Anatomy.Feet;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>Splits the flat end of a limb into toes or fingers side by side: the end is a grid of cells, and each digit grows from two columns of it.</summary>
internal static class Digits
{
    /// <summary>Largest radius of a toe relative to the distance between neighbours.</summary>
    private const float Crowding = 0.43f;

    /// <summary>Radians. Largest angle between the outer toes and straight ahead.</summary>
    private const float WidestSplay = 0.95f;

    /// <summary>Splay of the toes of a foot that trails in the water, relative to that of one that stands.</summary>
    private const float Closed = 0.42f;

    /// <summary>How far long toes under a body are turned out, in their splay: straight ahead they hold the legs apart like a wishbone.</summary>
    internal const float TurnedOut = 0.28f;

    /// <summary>Radius of a nail, in those of its toe.</summary>
    private const float NailSize = 0.85f;

    /// <summary>Half height of a disc at the end of a toe, in those of a plain toe's end.</summary>
    private const float FlattestDisc = 1.1f;

    private static readonly float[] sections = { 0f, 0.6f, 1.3f, 2f, 2.6f, 3f };
    private static readonly float[] reach = { 0f, 0.35f, 0.75f, 1f };
    private static readonly float[] spread = { 0f, 0.22f, 0.72f, 1f };

    /// <summary>Grows the digits of the left limb.</summary>
    public static void Grow(SurfaceBuilder surface, LegForm form, LegBlueprint leg, float thickness, SweepResult limb, int index, LimbEnds ends)
    {
        List<DigitTip> tips = ends.Tips;
        SweepFrame end = limb.Last;
        FootForm foot = FootForm.Of(leg.Foot);
        bool standing = leg.Stance == LegStance.Standing;
        bool hand = form.Handed;
        int half = limb.End.Length / 2;
        int columns = Math.Min(2 * leg.Toes, half - 2);
        columns -= columns % 2;
        int count = columns / 2;
        int rows = half - columns;
        float size = thickness * (float)leg.FootSize;

        // Who balances on one pair of feet stands over the middle of the toes of its leg's form.
        float length = (form.LongToed ? 1f : foot.Length) * form.ToeLength * (hand ? thickness * (float)leg.FootSize : size);
        float tipRadius = form.ToeRadius * (hand ? thickness : size * Math.Max((float)leg.Stoutness, 0.8f));

        // A foot that trails is rather closed.
        bool trails = form.Sprawling && !standing;
        float splay = (trails ? Closed : 1f) * Math.Min((form.LongToed ? Math.Min(1f, foot.Splay) : foot.Splay) * form.ToeSplay, WidestSplay);
        var address = new VertexAddress { Region = SurfaceRegion.Toe, Appendage = (short)index, Sign = 1, Along = 1f };
        int[] grid = CapGrid.Vertices(surface, limb.End, rows, columns, end.Tangent, end.ForeRadius * 0.15f, address);

        Vector3 side = trails ? end.Across : Vec.Normalize(new Vector3(end.Across.X, 0f, end.Across.Z), Vector3.UnitX);
        Vector3 ahead = end.Tangent;
        if (standing)
        {
            ahead = Vec.Cross(Vector3.UnitY, side);
            ahead = Vec.Dot(ahead, end.Tangent) > 0f ? ahead : -ahead;
        }

        if (standing && form.LongToed)
        {
            Quaternion turn = AxisRotation.Yaw(TurnedOut * splay);
            (side, ahead) = (Rotation.Rotate(turn, side), Rotation.Rotate(turn, ahead));
        }

        int[][] loops = new int[count][];
        var centres = new Vector3[count];
        float[] start = new float[count];
        float[] target = new float[count];
        for (int q = 0; q < count; q++)
        {
            loops[q] = SocketLoop.OfGrid(grid, columns + 1, 0, rows, 2 * q, (2 * q) + 2);
            centres[q] = SocketLoop.Mean(Array.ConvertAll(loops[q], v => surface.Positions[v]));
            start[q] = Vec.Dot(centres[q] - end.Centre, side);
            target[q] = Rank(q, count) * (end.AcrossRadius + (length * (float)(PortableMath.Sin(splay) / PortableMath.Cos(splay)) * 0.9f));
        }

        Vector3 roots = SocketLoop.Mean(centres);
        roots.Y = standing ? Math.Min(roots.Y, 0.5f * end.ForeRadius) : roots.Y;
        Vector3 before = Vector3.Zero;
        for (int q = 0; q < count; q++)
        {
            float rank = Rank(q, count);
            float digit = length * (1f - (0.18f * rank * rank));
            var joints = new Vector3[4];
            var radii = new Vector2[4];
            float foreEnd = standing ? end.ForeRadius * 0.9f : end.ForeRadius * 0.8f;
            float side0 = end.AcrossRadius / count;
            float[] fore = standing
                ? new[] { foreEnd, Math.Max(tipRadius, end.ForeRadius * 0.62f) * Math.Min(1f, foot.Radius.Middle), tipRadius * 1.05f * foot.Radius.Ball, tipRadius * 0.6f * Math.Min(foot.Radius.Tip, FlattestDisc) }
                : new[] { foreEnd, tipRadius * 1.1f, tipRadius, tipRadius * 0.6f };
            float[] sides = { side0 * 0.9f, Math.Max(side0 * 0.9f, tipRadius) * Math.Min(1f, foot.Radius.Middle), tipRadius * 1.08f * foot.Radius.Ball, tipRadius * 0.65f * foot.Radius.Tip };
            for (int k = 0; k < 4; k++)
            {
                float lateral = Scalar.Lerp(start[q], target[q], spread[k]);
                joints[k] = centres[q] + (ahead * (digit * reach[k])) + (side * (lateral - start[q]));
                if (k > 0)
                {
                    if (standing)
                    {
                        joints[k].Y = fore[k] * 0.72f;
                    }
                    else if (hand)
                    {
                        joints[k].Y -= 0.35f * digit * reach[k];
                    }
                }

                radii[k] = new Vector2(fore[k], Math.Min(sides[k], Crowding * Spacing(start, target, spread[k])));
            }

            var sweep = new LimbSweep
            {
                Joints = joints,
                Radii = radii,
                Sections = sections,
                Across = side,
                Blend = 0.45f,
                Floor = standing ? 0f : float.NegativeInfinity,
                Address = address,
                FixedAlong = 1f,
            };
            SweepResult grown = sweep.Grow(surface, loops[q]);
            Vector3 direction = Vec.Normalize(joints[3] - joints[2], ahead);
            int[] cap = CapGrid.Vertices(surface, grown.End, rows, 2, direction, Math.Min(tipRadius, radii[3].Y) * 0.5f, address);
            KeepAboveFloor(surface, cap, standing);
            CapGrid.Fill(surface, cap, rows, 2, surface.NewChart(), new Vector2(tipRadius * 2f, tipRadius * 2f));
            bool nailed = foot.Nailed && standing;
            float nail = NailSize * Math.Min(tipRadius, radii[2].Y);
            Vector3 at = new(joints[3].X, Math.Max(joints[3].Y, nail), joints[3].Z);
            tips.Add(nailed
                ? new DigitTip(DigitTipKind.Nail, at, ahead, nail, 0f, grown.End[0])
                : new DigitTip(DigitTipKind.Claw, joints[3], direction, Math.Min(tipRadius, radii[2].Y), (float)leg.ClawLength, grown.End[0]));
            if (foot.Web > 0f && q > 0)
            {
                Vector3 reach = joints[3] - joints[0];
                ends.Webs.Add(new ToeWeb(roots + (ahead * (0.1f * length)), before, joints[0] + (reach * foot.Web), 0.3f * radii[2].X, grown.End[0], standing ? 0f : float.NegativeInfinity));
            }

            before = joints[0] + ((joints[3] - joints[0]) * foot.Web);
        }

        if (foot.Hallux > 0f && standing)
        {
            Vector3 heel = end.Centre - (ahead * (0.6f * end.ForeRadius));
            heel.Y = tipRadius;
            tips.Add(new DigitTip(DigitTipKind.Hallux, heel, Vector3.Zero - ahead, tipRadius, foot.Hallux * length / tipRadius, limb.End[0]));
        }
    }

    private static void KeepAboveFloor(SurfaceBuilder surface, int[] cap, bool standing)
    {
        foreach (int v in cap)
        {
            Vector3 p = surface.Positions[v];
            if (standing && p.Y < 0f)
            {
                surface.Positions[v] = new Vector3(p.X, 0f, p.Z);
            }
        }
    }

    /// <summary>−1 for the first digit, 1 for the last.</summary>
    private static float Rank(int q, int count) => count > 1 ? (q - ((count - 1) / 2f)) / ((count - 1) / 2f) : 0f;

    private static float Spacing(float[] start, float[] target, float fraction)
    {
        float min = 9f;
        for (int q = 1; q < start.Length; q++)
        {
            float a = Scalar.Lerp(start[q - 1], target[q - 1], fraction);
            float b = Scalar.Lerp(start[q], target[q], fraction);
            min = Math.Min(min, Math.Abs(b - a));
        }

        return min;
    }
}

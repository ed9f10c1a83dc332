using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>Draws legs and arms for a body plan.</summary>
internal static class LegSampler
{
    /// <summary>Fills in the legs of the draft.</summary>
    public static void Sample(CreatureDraft draft)
    {
        var style = new LegStyle(draft);
        BodyShape s = draft.Shape;
        RandomStream random = draft.Stream("legs");
        switch (draft.Plan)
        {
            case BodyPlan.Digitigrade:
                Quadruped(draft, style, LimbArchetype.DigitigradeHind, LimbArchetype.DigitigradeFore, 1, 1, 27);
                break;
            case BodyPlan.Unguligrade:
                Quadruped(draft, style, LimbArchetype.UnguligradeHind, LimbArchetype.UnguligradeFore, 1, 1, 27);
                break;
            case BodyPlan.Plantigrade:
                Quadruped(draft, style, LimbArchetype.PlantigradeHind, LimbArchetype.PlantigradeFore, 1, 1, 27);
                break;
            case BodyPlan.Columnar:
                Quadruped(draft, style, LimbArchetype.Column, LimbArchetype.Column, 1.1, 1.15, 27);
                break;
            case BodyPlan.Centaur:
                Arm(draft, style, 23, 9.5, Scalar.Clamp(0.42 * s.Bottom[24], 0.05, 0.10), 0.55 * draft.HipHeight, 0.5 * draft.HipHeight);
                bool hoofed = draft.Family.Body == "bovine";
                Quadruped(draft, style, hoofed ? LimbArchetype.UnguligradeHind : LimbArchetype.DigitigradeHind, hoofed ? LimbArchetype.UnguligradeFore : LimbArchetype.DigitigradeFore, 1, 1, 30);
                break;
            case BodyPlan.Sprawling:
                double thickness = Scalar.Clamp(0.62 * draft.HalfDepth(41), 0.06, 0.16);
                double reach = random.Uniform(0.36, 0.5) * draft.TorsoLength * 0.62;
                Stand(draft, style, LimbArchetype.Sprawl, 41, 9.6, thickness, reach, -0.12, 0, 1);
                Stand(draft, style, LimbArchetype.Sprawl, 27, 9.6, thickness * 0.9, reach, 0.10, 0, 1);
                break;
            case BodyPlan.ManyLegged:
                int pairs = random.Integer(3, 6);
                for (int q = 0; q < pairs; q++)
                {
                    double at = (double)q / (pairs - 1);
                    Stand(draft, style with { Toes = 3 }, LimbArchetype.Sprawl, (int)Math.Round(25 + (17 * at)), 10, 0.06, 0.16, 0.15 - (0.3 * at), 0, 1, 4, 0);
                }

                break;
            case BodyPlan.Hexapod:
                Hexapod(draft, style, random);
                break;
            case BodyPlan.Upright:
                Upright(draft, style, random);
                break;
            case BodyPlan.Theropod:
                Theropod(draft, style, random);
                break;
            case BodyPlan.Flapping:
                FlierLegs(draft, style, random);
                break;
            case BodyPlan.Buzzing:
                BuzzerLegs(draft, style, random);
                break;
        }

        draft.Legs.Sort((a, b) => a.Socket.Ring.CompareTo(b.Socket.Ring));
    }

    private static void Quadruped(CreatureDraft draft, LegStyle style, LimbArchetype hind, LimbArchetype fore, double hindFactor, double foreFactor, int foreRing)
    {
        double thickHind = Scalar.Clamp(0.78 * draft.HalfDepth(41), 0.09, 0.24) * hindFactor * (draft.Signature == Signature.Rump ? 1.15 : 1);
        double thickFore = Scalar.Clamp(0.52 * draft.HalfDepth(27), 0.08, 0.22) * foreFactor * (draft.Signature == Signature.Hulk ? 1.3 : 1);
        double thin = style.Slimness * (draft.Signature == Signature.Hulk ? 1.08 : 1);
        Stand(draft, style with { Slimness = thin }, hind, 41, 10.6, thickHind, 0, 0, 0, 1);
        Stand(draft, style with { Slimness = thin * 1.08 }, fore, foreRing, 10.9, thickFore, 0, 0, 0.02, 1);
    }

    private static void Upright(CreatureDraft draft, LegStyle style, RandomStream random)
    {
        BodyShape s = draft.Shape;
        const int Ring = 40;
        double height = s.Y[Ring];
        double thickness = Scalar.Clamp(0.85 * draft.HalfDepth(Ring), 0.10, 0.26);
        double shear = Scalar.Clamp(((StanceSampler.CentreOfMass(s) - s.Z[Ring]) / Math.Max(height, 0.2)) - 0.08, -0.1, 0.55);
        LimbArchetype archetype = random.Chance(0.6) ? LimbArchetype.PlantigradeHind : LimbArchetype.DigitigradeHind;
        Stand(draft, style with { FootSize = style.FootSize * 1.15 }, archetype, Ring, 9.6, thickness, 0, 0, shear, 1);
        double dy = s.Y[26] - s.Y[40];
        double dz = s.Z[26] - s.Z[40];
        double length = Math.Sqrt((dy * dy) + (dz * dz));
        Arm(draft, style with { Toes = random.Integer(3, 5) }, 26, 8.8, Scalar.Clamp(0.55 * s.Bottom[26], 0.06, 0.14), length * random.Uniform(0.95, 1.25), length * 0.8);
    }

    private static void Theropod(CreatureDraft draft, LegStyle style, RandomStream random)
    {
        BodyShape s = draft.Shape;
        int ring = 34;
        for (int i = 35; i < 42; i++)
        {
            if (s.Width[i] + (0.5 * s.Bottom[i]) > s.Width[ring] + (0.5 * s.Bottom[ring]))
            {
                ring = i;
            }
        }

        double thickness = Scalar.Clamp(0.66 * draft.HalfDepth(ring), 0.10, 0.24);
        double height = s.Y[ring] - 0.06;
        double shear = Scalar.Clamp((StanceSampler.CentreOfMass(s) - s.Z[ring] - 0.04) / Math.Max(height, 0.2), -0.05, 0.45);
        Stand(draft, style with { Toes = 3, ClawLength = 1.1, Slimness = random.Uniform(0.9, 1.15) }, LimbArchetype.Theropod, ring, 10.4, thickness, 0, 0, shear, 1);
        bool bird = draft.Family.Body == "avian";
        if (random.Chance(bird ? 0.1 : 0.55))
        {
            double reach = 0.42 * draft.TorsoLength;
            Arm(draft, style with { Toes = random.Integer(2, 4) }, 26, 10.2, Scalar.Clamp(0.40 * s.Bottom[26], 0.04, 0.10), reach * random.Uniform(0.7, 1.2), reach);
        }
    }

    private static void Hexapod(CreatureDraft draft, LegStyle style, RandomStream random)
    {
        double reach = random.Uniform(0.24, 0.36);
        bool arms = random.Chance(0.3);
        if (arms)
        {
            Arm(draft, style with { Toes = 2, FootSize = 1.6, ClawLength = 1.4, Slimness = 1.1 }, 22, 9.5, 0.05, 0.30, 0.42 * 0.8, 4);
        }

        (int Ring, double Azimuth)[] places = arms ? new[] { (26, 0.5), (30, 0.0), (33, -0.55) } : new[] { (24, 0.55), (28, 0.0), (32, -0.55) };
        foreach ((int ring, double azimuth) in places)
        {
            Stand(draft, style with { FootSize = 1 }, LimbArchetype.Insect, ring, 10, 0.043 * random.Uniform(0.95, 1.25), reach * (azimuth == 0 ? 1 : 1.08), azimuth, 0, 1);
        }
    }

    private static void FlierLegs(CreatureDraft draft, LegStyle style, RandomStream random)
    {
        double torso = draft.TorsoLength;
        bool mammal = draft.Family.Body is "canine" or "feline" or "bovine";
        if (draft.Family.Body == "avian" || (!mammal && random.Chance(0.4)))
        {
            Hang(draft, style with { Toes = 3 }, LimbArchetype.Theropod, 39, 10.0, 0.62 * draft.HalfDepth(39), 0.58 * torso, 0.58 * torso, 0, -0.22);
            return;
        }

        Hang(draft, style, LimbArchetype.DigitigradeHind, 41, 10.8, 0.6 * draft.HalfDepth(41), 0.58 * torso, 0.58 * torso, 0, -0.18);
        Hang(draft, style, LimbArchetype.DigitigradeFore, 26, 11.0, 0.45 * draft.HalfDepth(27), 0.56 * torso, 0.56 * torso, 0, -0.08);
    }

    private static void BuzzerLegs(CreatureDraft draft, LegStyle style, RandomStream random)
    {
        foreach ((int ring, double azimuth) in new[] { (24, 0.45), (28, -0.1), (32, -0.7) })
        {
            Hang(draft, style with { FootSize = 1 }, LimbArchetype.Insect, ring, 10.6, 0.034 * random.Uniform(0.95, 1.15), 0.26, Math.Max(0.17, (0.72 * draft.Shape.Width[ring]) + 0.06), azimuth - 0.1, 0);
        }
    }

    /// <summary>A leg that stands; its reach follows from the height of its socket unless given.</summary>
    private static void Stand(CreatureDraft draft, LegStyle style, LimbArchetype archetype, int ring, double segment, double thickness, double reach, double azimuth, double shear, double kneeRise, int most = 8, int margin = 1)
    {
        SocketBlueprint socket = SocketPlanner.Size(draft.Shape, archetype, ring, segment, thickness, style.Toes, most);
        double height = SocketPlanner.Height(draft.Shape, socket);
        Add(draft, style, archetype, LegStance.Standing, socket, thickness, height, reach == 0 ? height : reach, azimuth, shear, kneeRise, margin);
    }

    private static void Hang(CreatureDraft draft, LegStyle style, LimbArchetype archetype, int ring, double segment, double thickness, double length, double reach, double azimuth, double shear)
    {
        SocketBlueprint socket = SocketPlanner.Size(draft.Shape, archetype, ring, segment, thickness, style.Toes, 8);
        Add(draft, style, archetype, LegStance.Hanging, socket, thickness, length, reach, azimuth, shear, 1, 1);
    }

    private static void Arm(CreatureDraft draft, LegStyle style, int ring, double segment, double thickness, double length, double reach, int most = 8)
    {
        SocketBlueprint socket = SocketPlanner.Size(draft.Shape, LimbArchetype.Arm, ring, segment, thickness, style.Toes, most);
        Add(draft, style with { ClawLength = Math.Max(style.ClawLength, 0.6) }, LimbArchetype.Arm, LegStance.Hanging, socket, thickness, length, reach, 0, 0, 1, 1);
    }

    private static void Add(CreatureDraft draft, LegStyle style, LimbArchetype archetype, LegStance stance, SocketBlueprint socket, double thickness, double length, double reach, double azimuth, double shear, double kneeRise, int margin)
    {
        if (draft.Sockets.TryTake(socket, archetype == LimbArchetype.Insect ? 0 : margin))
        {
            draft.Legs.Add(new LegBlueprint(archetype, stance, socket, thickness, length, reach, azimuth, shear, style.Slimness, style.Stoutness, style.FootSize, kneeRise, style.Toes, style.ClawLength));
        }
    }
}

/// <summary>What all legs of one creature share.</summary>
internal sealed record LegStyle
{
    public LegStyle(CreatureDraft draft)
    {
        RandomStream random = draft.Stream("leg style");
        Stoutness = CreatureDraft.Around(random, 1 + (0.05 * draft.Style), 0.08, 0.85, 1.25);
        FootSize = CreatureDraft.Around(random, 1.25 + (0.1 * draft.Style), 0.1, 1, 1.65);
        Slimness = CreatureDraft.Around(random, draft.Plan == BodyPlan.Unguligrade ? 1.02 : 1.12, 0.1, 0.85, 1.35);
        Toes = random.Integer(3, 5);
        bool soft = draft.Plan is BodyPlan.Digitigrade or BodyPlan.Plantigrade;
        ClawLength = soft ? CreatureDraft.Choose(random, (0.0, 0.35), (0.8, 0.3), (1.3, 0.35)) : random.Chance(0.5) ? 0.9 : 1.5;
    }

    public double Stoutness { get; init; }

    public double FootSize { get; init; }

    public double Slimness { get; init; }

    public int Toes { get; init; }

    public double ClawLength { get; init; }
}

/// <summary>Sizes of sockets from the thickness of what grows out of them.</summary>
internal static class SocketPlanner
{
    /// <summary>The cells of a limb: as many rows and columns as its root is long and wide, both even, enough for its toes.</summary>
    public static SocketBlueprint Size(BodyShape s, LimbArchetype archetype, int ring, double segment, double thickness, int toes, int most)
    {
        int rows = 2;
        int columns = 2;
        if (archetype != LimbArchetype.Insect)
        {
            double step = (s.Step[ring - 1] + s.Step[ring] + s.Step[ring + 1]) / 3;
            double depth = (s.Top[ring] + s.Bottom[ring]) / 2;
            double cell = PortableMath.Tau * Math.Sqrt(((s.Width[ring] * s.Width[ring]) + (depth * depth)) / 2) / BodyGrid.Segments;
            rows = Even(thickness / step, 4, most);
            columns = Even(thickness * 0.8 / cell, 4, Math.Min(most, 6));
            if (toes >= 3 && rows + columns < (2 * toes) + 2 && rows + 2 <= most)
            {
                if (rows < 8)
                {
                    rows += 2;
                }
                else if (columns < 6)
                {
                    columns += 2;
                }
            }
        }

        int first = (int)Math.Round(segment - (columns / 2.0));
        first = Math.Min(first, 15 - columns);
        return new SocketBlueprint(ring - (rows / 2), first, rows, columns);
    }

    /// <summary>Height of a socket's centre above the ground, metres.</summary>
    public static double Height(BodyShape s, SocketBlueprint socket)
    {
        int ring = socket.Ring + (socket.Rows / 2);
        double angle = PortableMath.Tau * (socket.Segment + (socket.Columns / 2.0)) / BodyGrid.Segments;
        double c = PortableMath.Cos(angle);
        double n = c > 0 ? s.TopExponent[ring] : s.BottomExponent[ring];
        double extent = c > 0 ? s.Top[ring] : -s.Bottom[ring];
        return s.Y[ring] + (extent * PortableMath.Pow(Math.Abs(c), 2 / n) * PortableMath.Cos(s.Pitch[ring]));
    }

    private static int Even(double cells, int least, int most) => Math.Max(least, Math.Min(most, 2 * (int)Math.Round(cells)));
}

using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>A joint of the spine before it is built.</summary>
internal readonly struct SpineNode
{
    public SpineNode(string name, JointRole role, double ring)
    {
        Name = name;
        Role = role;
        Ring = ring;
    }

    public string Name { get; }

    public JointRole Role { get; }

    /// <summary>Where its pivot lies.</summary>
    public double Ring { get; }
}

/// <summary>
/// How many joints the spine has and at which rings, from the body's plan and size.
/// </summary>
/// <remarks>
/// <para>Walkers and fliers: the body's root lies half way between pelvis and chest; a chain runs from the pelvis forward to the head, and the tail backward from the pelvis.
/// Pelvis and chest sit at the rearmost and the foremost limbs. Swimmers: the root lies behind the head; the head is one bone forward, the rest a chain to the tail.</para>
/// <para>The number of bones follows from the size of the body in metres (arc length times the creature's scale), by the tables below: bigger bodies bend in more places.
/// Plans that bend as a whole (eels, legless walkers) have more.</para>
/// </remarks>
internal sealed class SpineLayout
{
    private const double HeadRing = 15.3;
    private const double DefaultHipRing = 41;
    private const double DefaultShoulderRing = 27;
    private const double SwimmerRootRing = StationRing.TrunkFirst;
    private const double LastTailRing = 52;

    /// <summary>Length of the tail's bones of a legless body over that of its trunk's, and their greatest number.</summary>
    private const double LeglessTailSpacing = 1.1;

    private const int MaxLeglessTailBones = 12;

    /// <summary>Rings per bone at least: a bone between two rings would hold no skin.</summary>
    private const double RingsPerBone = 1.2;

    /// <summary>Metres of trunk from which on the spine has 3, 4 and 5 bones.</summary>
    private static readonly double[] trunkSteps = { 0.4, 1.1, 1.7 };

    /// <summary>Metres of trunk from which on a legless spine has 7 … 12 bones.</summary>
    private static readonly double[] leglessSteps = { 0.9, 1.2, 1.5, 1.9, 2.4, 3.0 };

    /// <summary>Metres of neck from which on it has 4 … 7 bones.</summary>
    private static readonly double[] neckSteps = { 0.7, 1.0, 1.4, 1.9 };

    /// <summary>Metres of tail from which on it has 4 … 10 bones.</summary>
    private static readonly double[] tailSteps = { 0.15, 0.3, 0.6, 0.9, 1.4, 2.0, 2.8 };

    /// <summary>Metres of swimmer behind the head from which on it has 10, 12, 14 and 16 bones.</summary>
    private static readonly double[] swimmerSteps = { 0.5, 0.9, 2.4, 3.6 };

    /// <summary>Metres of eel behind the head from which on it has 20, 22, 24 and 26 bones.</summary>
    private static readonly double[] eelSteps = { 1.0, 1.8, 4.5, 6.5 };

    private static readonly double[] neckRings = { 22.3, 19.6, 17.4 };

    /// <summary>Rings of the joints of a swimmer with 12 bones: closer together where the tail beats.</summary>
    private static readonly double[] swimmerRings = { 20, 24, 27, 30, 33, 36, 38.5, 41, 43.5, 45.5, 47.5, 50, 52 };

    private SpineLayout(double rootRing, double pelvisRing, double chestRing, SpineNode[] forward, SpineNode[] backward)
    {
        RootRing = rootRing;
        PelvisRing = pelvisRing;
        ChestRing = chestRing;
        Forward = forward;
        Backward = backward;
    }

    /// <summary>Ring of the body's root.</summary>
    public double RootRing { get; }

    /// <summary>Ring of the pelvis; of a swimmer the last ring of its trunk.</summary>
    public double PelvisRing { get; }

    /// <summary>Ring of the chest; of a swimmer the ring of its root.</summary>
    public double ChestRing { get; }

    /// <summary>Joints from the root to the head, which is the last.</summary>
    public SpineNode[] Forward { get; }

    /// <summary>Joints from the root (of walkers and fliers: from the pelvis) to the tail.</summary>
    public SpineNode[] Backward { get; }

    /// <summary>Lays out the spine.</summary>
    /// <param name="kind">How the creature moves.</param>
    /// <param name="plan">How it carries its body.</param>
    /// <param name="appendages">What grew out of the body.</param>
    /// <param name="line">The spine's line.</param>
    /// <param name="scale">Factor from the line's lengths to metres of the finished creature.</param>
    public static SpineLayout Plan(LocomotionKind kind, BodyPlan plan, IReadOnlyList<Appendage> appendages, SpineLine line, double scale) =>
        kind == LocomotionKind.Swimming ? Swimmer(plan, line, scale) : Walker(plan, appendages, line, scale);

    private static SpineLayout Walker(BodyPlan plan, IReadOnlyList<Appendage> appendages, SpineLine line, double scale)
    {
        double pelvis = PelvisOf(appendages);
        double chest = ChestOf(appendages, pelvis);
        var forward = new List<SpineNode> { new("Pelvis", JointRole.Pelvis, pelvis) };
        double trunk = (line.ArcAt(pelvis) - line.ArcAt(chest)) * scale;
        int bones = plan == BodyPlan.Legless ? 6 + StepsBelow(leglessSteps, trunk) : 2 + StepsBelow(trunkSteps, trunk);
        bones = Math.Min(bones, MaxBones(pelvis - chest) - 1);
        AddEvenly(forward, line, "Spine_", JointRole.Spine, pelvis, chest, bones);
        forward.Add(new SpineNode("Chest", JointRole.Chest, chest));
        AddNeck(forward, line, Math.Min(chest, 26), scale);
        forward.Add(new SpineNode("Head", JointRole.Head, HeadRing));

        double spacing = (line.ArcAt(pelvis) - line.ArcAt(chest)) / (bones + 1);
        double first = plan == BodyPlan.Legless ? Math.Min(line.RingAt(line.ArcAt(pelvis) + spacing), LastTailRing) : TailRootOf(pelvis);
        double last = Math.Max(LastTailRing, first);
        double tail = line.Length - line.ArcAt(first);
        int tailBones = 3 + StepsBelow(tailSteps, tail * scale);
        if (plan == BodyPlan.Legless)
        {
            // A body that bends as a whole bends as far in its tail as in its trunk.
            tailBones = Math.Max(tailBones, Math.Min((int)(tail / (LeglessTailSpacing * spacing)), MaxLeglessTailBones));
        }

        tailBones = Math.Min(tailBones, MaxBones(last - first));
        var backward = new List<SpineNode>();
        AddThrough(backward, line, "Tail_", JointRole.Tail, first, last, tailBones);
        double root = line.RingAt((line.ArcAt(pelvis) + line.ArcAt(chest)) / 2);
        return new SpineLayout(root, pelvis, chest, forward.ToArray(), backward.ToArray());
    }

    private static SpineLayout Swimmer(BodyPlan plan, SpineLine line, double scale)
    {
        var forward = new List<SpineNode>();
        double head = line.ArcAt(HeadRing);
        double neck = line.ArcAt(SwimmerRootRing) - head;

        // Most swimmers have no neck to speak of: the head turns as one with it.
        bool necked = neck > 1.2 * head;
        if (necked)
        {
            AddNeck(forward, line, SwimmerRootRing, scale);
        }

        forward.Add(new SpineNode("Head", JointRole.Head, necked ? HeadRing : SwimmerRootRing));

        var backward = new List<SpineNode>();
        double length = (line.Length - line.ArcAt(SwimmerRootRing)) * scale;
        if (plan == BodyPlan.Eel)
        {
            AddThrough(backward, line, "Spine_", JointRole.Spine, SwimmerRootRing, 53, Math.Min(18 + (2 * StepsBelow(eelSteps, length)), MaxBones(53 - SwimmerRootRing)));
        }
        else
        {
            int bones = 8 + (2 * StepsBelow(swimmerSteps, length));
            for (int i = 0; i < bones; i++)
            {
                double at = 12.0 * i / bones;
                int k = (int)at;
                backward.Add(new SpineNode(Numbered("Spine_", i + 1), JointRole.Spine, swimmerRings[k] + ((swimmerRings[k + 1] - swimmerRings[k]) * (at - k))));
            }
        }

        return new SpineLayout(SwimmerRootRing, 44, SwimmerRootRing, forward.ToArray(), backward.ToArray());
    }

    private static double PelvisOf(IReadOnlyList<Appendage> appendages)
    {
        double ring = double.NegativeInfinity;
        foreach (Appendage a in appendages)
        {
            ring = a.Kind == LimbKind.Leg ? Math.Max(ring, a.RootRing) : ring;
        }

        return double.IsNegativeInfinity(ring) ? DefaultHipRing : ring;
    }

    private static double ChestOf(IReadOnlyList<Appendage> appendages, double pelvis)
    {
        double ring = double.PositiveInfinity;
        foreach (Appendage a in appendages)
        {
            bool carries = a.Kind is LimbKind.Arm or LimbKind.Wing || (a.Kind == LimbKind.Leg && a.RootRing < pelvis - 6);
            ring = carries ? Math.Min(ring, a.RootRing) : ring;
        }

        // Whatever is planned, the chest stays behind the neck and ahead of the pelvis.
        ring = double.IsPositiveInfinity(ring) ? DefaultShoulderRing : ring;
        return Math.Min(Math.Max(ring, 18), pelvis - 3);
    }

    /// <summary>Ring of the first tail joint: the tail base of four-footed bodies, behind the hips of two-footed ones, the waist of insects.</summary>
    private static double TailRootOf(double pelvis)
    {
        double root = pelvis >= 41 ? Math.Max(44, pelvis + 2.5) : pelvis >= 36 ? Math.Max(41, pelvis + 2.5) : pelvis + 4;
        return Math.Min(root, 53);
    }

    private static void AddNeck(List<SpineNode> nodes, SpineLine line, double from, double scale)
    {
        double length = (line.ArcAt(from) - line.ArcAt(HeadRing)) * scale;
        int bones = 3 + StepsBelow(neckSteps, length);
        if (bones > 3)
        {
            double first = from > neckRings[0] + 2 ? neckRings[0] : from - 1;
            AddThrough(nodes, line, "Neck_", JointRole.Neck, first, HeadRing + 1.4, Math.Min(bones, MaxBones(first - HeadRing - 1.4)));
            return;
        }

        int number = 0;
        foreach (double ring in neckRings)
        {
            if (ring < from - 2)
            {
                nodes.Add(new SpineNode(Numbered("Neck_", ++number), JointRole.Neck, ring));
            }
        }
    }

    /// <summary>Adds joints evenly in arc length strictly between two rings.</summary>
    private static void AddEvenly(List<SpineNode> nodes, SpineLine line, string name, JointRole role, double from, double to, int count)
    {
        double a = line.ArcAt(from);
        double b = line.ArcAt(to);
        for (int i = 1; i <= count; i++)
        {
            nodes.Add(new SpineNode(Numbered(name, i), role, line.RingAt(a + ((b - a) * i / (count + 1)))));
        }
    }

    /// <summary>Adds joints from one ring to another, both included, evenly in arc length as far as each has rings enough.</summary>
    private static void AddThrough(List<SpineNode> nodes, SpineLine line, string name, JointRole role, double first, double last, int count)
    {
        double a = line.ArcAt(first);
        double b = line.ArcAt(last);
        double way = last < first ? -1 : 1;
        double[] rings = new double[count];
        for (int i = 0; i < count; i++)
        {
            double ring = way * (count == 1 ? first : line.RingAt(a + ((b - a) * i / (count - 1))));
            rings[i] = i == 0 ? ring : Math.Max(ring, rings[i - 1] + RingsPerBone);
        }

        // Where rings are far apart, as in long tails, bones of one length would lie between two of them.
        double next = (way * last) + RingsPerBone;
        for (int i = count - 1; i >= 0; i--)
        {
            rings[i] = Math.Min(rings[i], next - RingsPerBone);
            next = rings[i];
        }

        for (int i = 0; i < count; i++)
        {
            nodes.Add(new SpineNode(Numbered(name, i + 1), role, way * rings[i]));
        }
    }

    private static int MaxBones(double rings) => 1 + (int)Math.Max(rings / RingsPerBone, 0);

    private static int StepsBelow(double[] steps, double value)
    {
        int count = 0;
        while (count < steps.Length && value >= steps[count])
        {
            count++;
        }

        return count;
    }

    private static string Numbered(string name, int number) => name + number.ToString("00", CultureInfo.InvariantCulture);
}

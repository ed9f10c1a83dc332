using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics;

/// <summary>
/// Crosses two blueprints by linked groups: what has to fit together comes from one parent, what can be mixed is mixed by region. What does not fit all the same is left to the repair.
/// </summary>
internal static class Crossover
{
    /// <summary>How far head and tail go towards the parent that gives them.</summary>
    private const double RegionFraction = 0.85;

    /// <summary>Slices of the lattice that belong to the head, and the first that belongs to the tail.</summary>
    private const int HeadSlices = 3;
    private const int TailSlice = 8;

    /// <summary>The child of two valid blueprints before mutation and repair. Any kinds and plans may be crossed.</summary>
    public static CreatureBlueprint Cross(CreatureBlueprint first, CreatureBlueprint second, Seed seed) => Cross(first, second, seed, out _);

    public static CreatureBlueprint Cross(CreatureBlueprint first, CreatureBlueprint second, Seed seed, out Inheritance inheritance)
    {
        inheritance = Inheritance.Draw(seed.Child("groups").Stream());
        RandomStream random = seed.Child("shares").Stream();
        CreatureBlueprint Of(ParentName name) => name == ParentName.First ? first : second;
        CreatureBlueprint frame = Of(inheritance.Frame);
        CreatureBlueprint other = ReferenceEquals(frame, first) ? second : first;
        CreatureBlueprint head = Of(inheritance.Head);
        CreatureBlueprint tail = Of(inheritance.Tail);
        CreatureBlueprint ornaments = Of(inheritance.Ornaments);
        CreatureBlueprint skin = Of(inheritance.Skin);
        double torso = random.Uniform(0.3, 0.55);
        double headFraction = ReferenceEquals(head, frame) ? 1 - RegionFraction : RegionFraction;
        double tailFraction = ReferenceEquals(tail, frame) ? 1 - RegionFraction : RegionFraction;
        double size = random.Uniform(0.3, 0.7);
        return frame with
        {
            Scale = Mix(frame.Scale, other.Scale, size),
            TriangleBudget = Math.Max(frame.TriangleBudget, other.TriangleBudget),
            Body = frame.Body with
            {
                Blend = MixBodies(frame.Body.Blend, other.Body.Blend, torso, headFraction, tailFraction) with { Face = head.Body.Blend.Face, Skin = skin.Body.Blend.Skin, Manner = frame.Body.Blend.Manner },
                Proportions = MixProportions(frame.Body.Proportions, other.Body.Proportions, torso, headFraction, tailFraction),
                Posture = frame.Plan == other.Plan ? FieldBlend.Between(frame.Body.Posture, other.Body.Posture, torso, BodyFields.Posture) : frame.Body.Posture,
                Slices = MixSlices(frame.Body.Slices, other.Body.Slices, torso, headFraction, tailFraction),
                Elevation = frame.Plan == other.Plan ? Mix(frame.Body.Elevation, other.Body.Elevation, torso) : frame.Body.Elevation,
                Shell = CarriesShell(frame.Plan) ? ornaments.Body.Shell : frame.Body.Shell,
            },
            Head = head.Head,
            Tail = TailOf(frame, tail, skin),
            Legs = Legs(frame, other, torso),
            Wings = Wings(frame, other, ornaments, torso),
            Fins = Fins(frame, other, torso),
            Ears = head.Ears,
            Features = Features(head, ornaments),
            Manes = ornaments.Manes,
            Frills = ornaments.Frills,
            Coat = Coat(skin, ReferenceEquals(skin, first) ? second : first, head, random),
        };
    }

    private static double Mix(double a, double b, double fraction) =>
        a > 0 && b > 0 ? PortableMath.Exp(((1 - fraction) * PortableMath.Log(a)) + (fraction * PortableMath.Log(b))) : a + (fraction * (b - a));

    private static double Lerp(double a, double b, double fraction) => a + (fraction * (b - a));

    /// <summary>Mixes the bodies of both, each region at its own share, and keeps the greatest that a mix has room for.</summary>
    private static BodyBlend MixBodies(BodyBlend frame, BodyBlend other, double torso, double head, double tail)
    {
        var parts = new List<(string Name, double Torso, double Head, double Tail)>();
        Add(frame, 1 - torso, 1 - head, 1 - tail);
        Add(other, torso, head, tail);

        // The frame's first body stays the first; the others follow by what they give.
        parts.Sort(1, parts.Count - 1, Comparer<(string Name, double Torso, double Head, double Tail)>.Create((a, b) => (b.Torso + b.Head + b.Tail).CompareTo(a.Torso + a.Head + a.Tail)));
        int count = Math.Min(parts.Count, BodyFields.MaxBodies);
        var bodies = new MixedBody[count];
        double torsoSum = 0, headSum = 0, tailSum = 0;
        for (int i = 0; i < count; i++)
        {
            (string name, double t, double h, double e) = parts[i];
            torsoSum += t;
            headSum += h;
            tailSum += e;
            bodies[i] = new MixedBody(name, Part(t, torsoSum), Part(h, headSum), Part(e, tailSum));
        }

        return frame with { Bodies = new ValueList<MixedBody>(bodies) };

        static double Part(double fraction, double sum) => sum > 0 ? fraction / sum : 0;

        void Add(BodyBlend blend, double t, double h, double e)
        {
            for (int i = 0; i < blend.Bodies.Count; i++)
            {
                string name = blend.Bodies[i].Name;
                (double Torso, double Head, double Tail) fractions = (t * blend.TorsoFractions[i], h * blend.HeadFractions[i], e * blend.TailFractions[i]);
                int known = parts.FindIndex(part => part.Name == name);
                if (known < 0)
                {
                    parts.Add((name, fractions.Torso, fractions.Head, fractions.Tail));
                }
                else
                {
                    parts[known] = (name, parts[known].Torso + fractions.Torso, parts[known].Head + fractions.Head, parts[known].Tail + fractions.Tail);
                }
            }
        }
    }

    private static BodyProportions MixProportions(BodyProportions a, BodyProportions b, double torso, double head, double tail) => new(
        Mix(a.Head, b.Head, head),
        Mix(a.Snout, b.Snout, head),
        Mix(a.Neck, b.Neck, torso),
        Mix(a.NeckGirth, b.NeckGirth, torso),
        Mix(a.Girth, b.Girth, torso),
        Mix(a.Belly, b.Belly, torso),
        Mix(a.Chest, b.Chest, torso),
        Mix(a.Hump, b.Hump, torso),
        Mix(a.Rump, b.Rump, torso),
        Mix(a.Tail, b.Tail, tail),
        Mix(a.TailGirth, b.TailGirth, tail),
        Mix(a.Depth, b.Depth, torso),
        Mix(a.Width, b.Width, torso));

    private static ValueList<LatticeSlice> MixSlices(ValueList<LatticeSlice> a, ValueList<LatticeSlice> b, double torso, double head, double tail)
    {
        var mixed = new LatticeSlice[a.Count];
        for (int i = 0; i < mixed.Length; i++)
        {
            double fraction = i < HeadSlices ? head : i >= TailSlice ? tail : torso;
            mixed[i] = new LatticeSlice(Mix(a[i].Width, b[i].Width, fraction), Mix(a[i].Height, b[i].Height, fraction), Mix(a[i].Length, b[i].Length, fraction));
        }

        return new ValueList<LatticeSlice>(mixed);
    }

    /// <summary>Hard covers lie on backs that legs carry level.</summary>
    private static bool CarriesShell(BodyPlan plan) => plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Sprawling or BodyPlan.Hexapod;

    /// <summary>A swimmer swims by the tail of its own frame; a fish's fan on fur looks stuck on, and so do feathers on anything but feathers or a flier.</summary>
    private static TailBlueprint TailOf(CreatureBlueprint frame, CreatureBlueprint tail, CreatureBlueprint skin)
    {
        if (frame.Kind == LocomotionKind.Swimming || tail.Tail.Style == TailStyle.Plain)
        {
            return frame.Kind == LocomotionKind.Swimming ? frame.Tail : tail.Tail;
        }

        bool feathers = tail.Tail.Style == TailStyle.Feathers;
        bool fits = feathers ? frame.Kind == LocomotionKind.Flying || skin.Tail.Style == TailStyle.Feathers : tail.Kind != LocomotionKind.Swimming;
        return fits ? tail.Tail : new TailBlueprint(TailStyle.Plain, 0, 0);
    }

    private static ValueList<LegBlueprint> Legs(CreatureBlueprint frame, CreatureBlueprint other, double fraction)
    {
        ValueList<LegBlueprint> legs = frame.Legs;
        for (int i = 0; i < legs.Count && other.Legs.Count > 0; i++)
        {
            LegBlueprint a = legs[i];
            LegBlueprint b = other.Legs[Math.Min(i, other.Legs.Count - 1)];
            bool alike = a.Archetype == b.Archetype && a.Stance == b.Stance;
            LegBlueprint build = a with { Stoutness = Mix(a.Stoutness, b.Stoutness, fraction), FootSize = Mix(a.FootSize, b.FootSize, fraction), ClawLength = Lerp(a.ClawLength, b.ClawLength, fraction) };
            legs = legs.With(i, alike ? FieldBlend.Between(a, b, fraction, LimbFields.Leg) : build);
        }

        return legs;
    }

    private static ValueList<WingBlueprint> Wings(CreatureBlueprint frame, CreatureBlueprint other, CreatureBlueprint ornaments, double fraction)
    {
        ValueList<WingBlueprint> wings = frame.Wings;
        for (int i = 0; i < wings.Count && i < other.Wings.Count; i++)
        {
            WingBlueprint a = wings[i], b = other.Wings[i];
            if ((a.Style == WingStyle.Folded) == (b.Style == WingStyle.Folded))
            {
                wings = wings.With(i, FieldBlend.Between(a, b, fraction, LimbFields.Wing) with { Style = i < ornaments.Wings.Count ? ornaments.Wings[i].Style : a.Style });
            }
        }

        return wings;
    }

    private static ValueList<FinBlueprint> Fins(CreatureBlueprint frame, CreatureBlueprint other, double fraction)
    {
        ValueList<FinBlueprint> fins = frame.Fins;
        for (int i = 0; i < fins.Count && i < other.Fins.Count; i++)
        {
            bool alike = fins[i].Place == other.Fins[i].Place && fins[i].Style == other.Fins[i].Style;
            fins = alike ? fins.With(i, FieldBlend.Between(fins[i], other.Fins[i], fraction, LimbFields.Fin)) : fins;
        }

        return fins;
    }

    /// <summary>Feelers, jaws and lures belong to a head and come with it; all else with the ornaments.</summary>
    private static ValueList<FeatureBlueprint> Features(CreatureBlueprint head, CreatureBlueprint ornaments)
    {
        var parts = new List<FeatureBlueprint>();
        foreach (FeatureBlueprint part in ornaments.Features)
        {
            if (!IsOfHead(part))
            {
                parts.Add(part);
            }
        }

        foreach (FeatureBlueprint part in head.Features)
        {
            if (IsOfHead(part) && parts.Count < CreatureFields.MaxFeatures)
            {
                parts.Add(part);
            }
        }

        return new ValueList<FeatureBlueprint>(parts);
    }

    private static bool IsOfHead(FeatureBlueprint part) => part.Ring < StationRing.Nape && part.Kind is FeatureKind.Antenna or FeatureKind.Mandible or FeatureKind.Lure or FeatureKind.Tusk or FeatureKind.Ocellus;

    /// <summary>One parent's skin, now and then with belly, legs or marks of the other; eyes come with the head.</summary>
    private static CoatBlueprint Coat(CreatureBlueprint skin, CreatureBlueprint other, CreatureBlueprint head, RandomStream random)
    {
        CoatBlueprint coat = skin.Coat;
        return coat with
        {
            Iris = head.Coat.Iris,
            Belly = random.Chance(0.25) ? other.Coat.Belly : coat.Belly,
            Limb = random.Chance(0.25) ? other.Coat.Limb : coat.Limb,
            Accent = random.Chance(0.4) ? other.Coat.Accent : coat.Accent,
            PatternScale = Mix(coat.PatternScale, other.Coat.PatternScale, 0.3),
        };
    }
}

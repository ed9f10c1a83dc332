using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Gives fliers their wings where the attachment rules put them.</summary>
internal static class WingSampler
{
    /// <summary>Fore and hind wings of insects; where they sit is the placement's.</summary>
    private static readonly ThinWing[] insectWings = { new(ring: 0, length: 1.05, width: 0.28, azimuth: -6, elevation: 36), new(ring: 0, length: 0.76, width: 0.23, azimuth: -36, elevation: 26) };

    /// <summary>Those of heavier bodies, of each family one: long and broad, or they would look too small to carry them.</summary>
    private static readonly ThinWing[][] fairyWings =
    {
        new ThinWing[] { new(ring: 0, length: 1.45, width: 0.44, azimuth: 0, elevation: 32), new(ring: 0, length: 1.0, width: 0.36, azimuth: -40, elevation: 20) },
        new ThinWing[] { new(ring: 0, length: 1.6, width: 0.36, azimuth: 2, elevation: 28, style: ThinWingStyle.DragonflyFore), new(ring: 0, length: 1.4, width: 0.46, azimuth: -20, elevation: 18, style: ThinWingStyle.DragonflyHind) },
        new ThinWing[] { new(ring: 0, length: 1.3, width: 0.78, azimuth: -20, elevation: 38, style: ThinWingStyle.ButterflyFore), new(ring: 0, length: 1.05, width: 0.82, azimuth: -1, elevation: 26, style: ThinWingStyle.ButterflyHind) },
        new ThinWing[] { new(ring: 0, length: 1.4, width: 0.7, azimuth: -14, elevation: 32, style: ThinWingStyle.MothFore), new(ring: 0, length: 1.1, width: 0.66, azimuth: -12, elevation: 20, style: ThinWingStyle.MothHind) },
    };

    private static readonly Weighted<WingStyle>[] membranes = 
        Weights.Of((WingStyle.Bat, 0.3), (WingStyle.GlidingLizard, 0.1), (WingStyle.Dragon, 0.28), (WingStyle.FlyingFish, 0.12), (WingStyle.Pterosaur, 0.2));
    private static readonly Weighted<WingStyle>[] feathers =
        Weights.Of((WingStyle.Feathered, 0.25), (WingStyle.Falcon, 0.2), (WingStyle.Owl, 0.25), (WingStyle.Albatross, 0.15), (WingStyle.Hummingbird, 0.15));

    /// <summary>Metres. Wings of a shorter torso are as large as this one's, but no more enlarged than so many times.</summary>
    private const double MinTorso = 0.66;
    private const double MaxEnlargement = 1.4;

    /// <summary>Longest wing, in torsos: longer ones are whips on a small body.</summary>
    private const double LongestWing = 1.6;

    /// <summary>Deepest wing, in torsos: a deeper one would hide the body.</summary>
    public const double DeepestWing = 0.66;

    // Least depth of a wing, in spans and in depths of the trunk between the girdles; and how many times as deep as its form a wing may become for it.
    private const double SlimmestOfSpan = 0.29;
    private const double SlimmestOfTrunk = 0.95;
    private const double MaxDeepening = 1.6;
    private const int FirstOfTrunk = 26;
    private const int LastOfTrunk = 40;

    /// <summary>Least rise of a wing of feathers; membranes are deep enough to be seen from the side.</summary>
    private const double LeastOfFeathers = 0.54;

    /// <summary>By how much wings of feathers of mixed bodies are shorter than their form has them at most: they are most of an outline, and all alike make doubles. Longer ones, and membranes of other lengths, would not fold onto the body.</summary>
    private const double ShortestOfForm = 0.2;

    // The same of membranes: by how much shallower they are at most, and by how much their rise and their sweep differ to either side. Bats, dragons and flying fish that are held alike have one outline.
    private const double ShallowestMembrane = 0.22;
    private const double RiseOfMembranes = 0.15;
    private const double SweepOfMembranes = 0.12;

    /// <summary>The sweep in the middle of all, and how much more than those of membranes the sweeps of feathers differ.</summary>
    private const double MiddleSweep = 0.31;
    private const double SweepOfFeathers = 1.6;

    /// <summary>Degrees; thin wings that point farther back lie along the body.</summary>
    private const double FoldedAzimuth = -60;

    /// <summary>Length of the torso that a creature's wings are made for, metres: those of small bodies are larger for it.</summary>
    public static double CarriedTorso(CreatureBuilder builder) => Math.Min(Math.Max(builder.TorsoLength, MinTorso), MaxEnlargement * builder.TorsoLength);

    /// <summary>Depth of a spread wing, metres: that of its form, but on mixed bodies no slimmer than so much of its span, and of the trunk's depth: a narrower one is a line on a small body and a stub on a stout one.</summary>
    public static double DepthOf(CreatureBuilder builder, WingForm form, double span)
    {
        BodyShape shape = builder.Shape;
        double trunk = 0;
        for (int ring = FirstOfTrunk; ring <= LastOfTrunk; ring++)
        {
            trunk = Math.Max(trunk, shape.Top[ring] + shape.Bottom[ring]);
        }

        double own = form.Depth * span;
        double min = Math.Min(Math.Max(SlimmestOfSpan * span, SlimmestOfTrunk * trunk), MaxDeepening * own);
        return Scalar.Lerp(own, Math.Max(own, min), builder.Fitting);
    }

    /// <summary>Adds thin wings of a species' own. They are most of an outline, so that those of mixed creatures differ in form and in how they are held.</summary>
    public static void AddThin(CreatureBuilder builder, ThinWing[] wings)
    {
        RandomStream random = builder.Stream("thin wings");
        double size = random.Uniform(0.9, 1.1);
        double breadth = random.Uniform(0.92, 1.08);
        double rise = random.Uniform(-1, 1);
        RandomStream form = builder.Stream("thin wing form");
        double longer = form.Uniform(-0.2, 0.15);
        double broader = form.Uniform(-0.2, 0.1);
        double hind = form.Uniform(-0.25, 0.2);
        double higher = form.Uniform(-9, 7);
        double parted = form.Uniform(-3, 12);
        for (int i = 0; i < wings.Length; i++)
        {
            ThinWing wing = wings[i];
            bool folded = wing.Azimuth < FoldedAzimuth;
            double freedom = folded ? 0 : builder.Fitting;
            double scale = (1 + (freedom * longer)) * (i == 0 ? 1 : 1 + (freedom * hind));
            double width = wing.Width * size * breadth * scale * (1 + (freedom * broader));
            double azimuth = wing.Azimuth + (freedom * (i == 0 ? parted : -parted));
            double elevation = wing.Elevation + (folded ? 0 : 6 * rise) + (freedom * higher);
            builder.InsectWings.Add(new InsectWingBlueprint(wing.Ring, 2.5, wing.Length * size * scale, width, Scalar.Radians(azimuth), Scalar.Radians(elevation), wing.Style));
        }
    }

    /// <summary>Folds the wings of a walking bird along its flanks.</summary>
    public static void AddFolded(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("folded wings");
        double ring = Math.Min(52, (builder.Parents.Legs.Bird?.FoldRing ?? 45.5) + random.Uniform(-0.8, 0.8));
        var socket = new SocketBlueprint(Ring: 24, Segment: 4, Rows: 2, Columns: 4);
        double span = BodyShape.At(builder.Shape.Arc, ring) - builder.Shape.Arc[StationRing.WingRoot];
        if (builder.Sockets.TryReserve(socket, 0))
        {
            builder.Wings.Add(new WingBlueprint(WingStyle.Folded, socket, span, 0.3, 0.05 / span, 0));
        }
    }

    /// <summary>The family of its spread wings: one of those of the parent that gives them.</summary>
    public static WingStyle StyleOf(CreatureBuilder builder, RandomStream random)
    {
        SpeciesProfile species = builder.Parents.Wings;
        bool membrane = random.Chance(species.WingMembrane);
        Weighted<WingStyle>[] styles = species.WingStyles ?? (membrane ? membranes : feathers);
        return CreatureBuilder.Choose(builder.Stream("wing style"), styles);
    }

    /// <summary>Adds the wings of a placement to the creature.</summary>
    public static void Add(CreatureBuilder builder, FlyingPlacement placement)
    {
        RandomStream random = builder.Stream("wings");
        WingStyle style = StyleOf(builder, random);
        WingForm form = WingForm.Of(style);

        // Hardly raised, a wing of feathers is a stub from the side; hardly swept, a raised one is its own edge from there.
        double rise = random.Uniform(0.42, 0.75);
        rise = form.Feathers > 0 ? Math.Max(LeastOfFeathers, rise) : rise;
        double sweep = random.Uniform(0.22, 0.4);
        sweep = form.Feathers > 0 ? MiddleSweep + (SweepOfFeathers * (sweep - MiddleSweep)) : sweep;
        double shorter = form.Feathers == 0 ? 1 : 1 - (builder.Fitting * builder.Stream("length of wings").Uniform(0, ShortestOfForm));
        RandomStream membrane = builder.Stream("form of membranes");
        double free = form.Feathers > 0 ? 0 : builder.Fitting;
        rise += free * membrane.Uniform(-RiseOfMembranes, RiseOfMembranes);
        sweep += free * membrane.Uniform(-SweepOfMembranes, SweepOfMembranes);
        double shallower = 1 - (free * membrane.Uniform(0, ShallowestMembrane));
        ThinWing[] thins = builder.Species.Class == AnimalClass.Arthropod ? insectWings : fairyWings[builder.Stream("thin wing family").Integer(0, fairyWings.Length)];
        foreach (WingPlacement wing in placement.Wings)
        {
            if (wing.Socket is SocketBlueprint socket)
            {
                if (builder.Sockets.TryReserve(socket, 0))
                {
                    double torso = CarriedTorso(builder);
                    double span = Math.Min(1.36 * form.Span * shorter * wing.Scale.X, LongestWing) * torso;
                    double chord = Math.Min(DepthOf(builder, form, span) * shallower * random.Uniform(0.9, 1.15), DeepestWing * torso);
                    builder.Wings.Add(new WingBlueprint(style, socket, span, chord, rise, sweep));
                }
            }
            else
            {
                ThinWing thin = thins[builder.InsectWings.Count == 0 ? 0 : 1];
                double elevation = Scalar.Radians(thin.Elevation * wing.Scale.Y);
                builder.InsectWings.Add(new InsectWingBlueprint(wing.Ring, 2.6, thin.Length * wing.Scale.X, thin.Width * wing.Scale.Z, Scalar.Radians(thin.Azimuth), elevation, thin.Style));
            }
        }
    }
}

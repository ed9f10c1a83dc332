using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Winged;

/// <summary>Some of the skin of a left wing, evenly chosen: places all over it, and triangles in its creases, where it goes over from bone to bone.</summary>
internal sealed class WingSkin
{
    private const int MaxPlaces = 80;
    private const int MaxCreases = 60;

    /// <summary>How far apart places are at most on the large triangles of thin wings, lengths of the wing: knees are no wider.</summary>
    private const double Spacing = 0.1;

    /// <summary>Share of the wing's joints from which on skin belongs to the wing.</summary>
    private const float MinFraction = 0.6f;

    /// <summary>Share of one joint, or of the body, from which on skin lies in no crease.</summary>
    private const float MaxOfOne = 0.9f;

    /// <summary>Part of its area below which a triangle is crowded: somewhat before it shrinks to a quarter.</summary>
    private const double Crowded = 0.4;

    /// <summary>How much the place that is deepest in a leg counts beside the mean of all: one knee through a wing is seen.</summary>
    private const double WorstFraction = 0.1;

    /// <summary>By which part of it a sum of some hundred numbers depends on their order at the most, with room to spare.</summary>
    private const double Rounding = 1e-9;

    private readonly PairedChain chain;
    private readonly Spot[] spots;
    private readonly Crease[] creases;
    private readonly double[] costs;
    private readonly int[] order;

    private WingSkin(PairedChain chain, Spot[] spots, Crease[] creases)
    {
        this.chain = chain;
        this.spots = spots;
        this.creases = creases;
        costs = new double[spots.Length];
        order = new int[spots.Length];
        for (int i = 0; i < order.Length; i++)
        {
            order[i] = i;
        }
    }

    /// <summary>Chooses the skin of a pair's left wing.</summary>
    public static WingSkin Of(MotionSubject subject, PairedChain chain)
    {
        CreatureMesh mesh = subject.Mesh;
        var places = new Place[mesh.Positions.Length];
        var found = new List<Place>();
        for (int v = 0; v < places.Length; v++)
        {
            places[v] = PlaceOf(chain, mesh.Positions[v], mesh.Weights[v]);
            if (places[v].Still < 1f - MinFraction)
            {
                found.Add(places[v]);
            }
        }

        bool thin = chain.Limb.Kind == LimbKind.InsectWing;
        double spacing = Spacing * chain.Reach;
        var bent = new List<(int A, int B, int C)>();
        ReadOnlySpan<int> triangles = mesh.Triangles;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            (int a, int b, int c) = (triangles[t], triangles[t + 1], triangles[t + 2]);
            if (places[a].Bends && places[b].Still < MaxOfOne && places[c].Still < MaxOfOne)
            {
                bent.Add((a, b, c));
            }

            if (thin && places[a].Still < 1f - MinFraction)
            {
                Fill(found, places[a], places[b], places[c], spacing);
            }
        }

        Spot[] spots = Array.ConvertAll(Some(found, thin ? 4 * MaxPlaces : MaxPlaces), place => Spot.Of(chain, place));
        Crease[] creases = Array.ConvertAll(Some(bent, MaxCreases), at =>
        {
            (Place a, Place b, Place c) = (places[at.A], places[at.B], places[at.C]);
            return new Crease(Spot.Of(chain, a), Spot.Of(chain, b), Spot.Of(chain, c), Area(a.Rest, b.Rest, c.Rest));
        });
        return new WingSkin(chain, spots, creases);
    }

    /// <summary>What it costs the places of the wing to be where they are, in the mean, and the one that is deepest in a leg.</summary>
    /// <param name="joints">Places of the joints.</param>
    /// <param name="turns">How they are turned in the model.</param>
    /// <param name="room">The body it is folded to.</param>
    /// <param name="range">How its kind of wing folds.</param>
    /// <param name="max">What it may cost: infinity is told of all that is dearer for certain.</param>
    public double Cost(ReadOnlySpan<Vector3> joints, ReadOnlySpan<Quaternion> turns, FoldRoom room, FoldRange range, double max)
    {
        // No place costs less than nothing and the deepest only gets deeper, so what is dear is known to be before all places have been looked at, the dearest of the way before first: that saves two thirds of them. The sum itself is made in their own order.
        double enough = max * Math.Max(spots.Length, 1) * (1 + Rounding);
        double worstWeight = WorstFraction * Math.Max(spots.Length, 1);
        double sum = 0;
        double worst = 0;
        for (int i = 0; i < order.Length; i++)
        {
            int number = order[i];
            ref readonly Spot spot = ref spots[number];
            Vector3 at = spot.At(joints, turns);
            double legs = room.CostOfLegs(at, range);
            double cost = room.Cost(at, range, spot.Clear) + legs;
            costs[number] = cost;
            worst = Math.Max(worst, legs);
            sum += cost;
            if (sum + (worstWeight * worst) > enough)
            {
                Prefer(i);
                return double.PositiveInfinity;
            }
        }

        sum = 0;
        foreach (double cost in costs)
        {
            sum += cost;
        }

        return (sum / Math.Max(spots.Length, 1)) + (WorstFraction * worst);
    }

    /// <summary>Sorts the places that were looked at, the dearest first; those of equal cost stay as they are.</summary>
    private void Prefer(int last)
    {
        for (int i = 1; i <= last; i++)
        {
            int number = order[i];
            int k = i;
            for (; k > 0 && costs[order[k - 1]] < costs[number]; k--)
            {
                order[k] = order[k - 1];
            }

            order[k] = number;
        }
    }

    /// <summary>How crowded the creases are in the mean, 0..1: squares of what triangles lack.</summary>
    public double Crowding(ReadOnlySpan<Vector3> joints, ReadOnlySpan<Quaternion> turns)
    {
        double sum = 0;
        foreach (Crease crease in creases)
        {
            double area = Area(crease.A.At(joints, turns), crease.B.At(joints, turns), crease.C.At(joints, turns));
            double lack = Math.Max(0, 1 - (area / (Crowded * crease.Area)));
            sum += lack * lack;
        }

        return sum / Math.Max(creases.Length, 1);
    }

    /// <summary>Lays all triangles of the wing onto the flank.</summary>
    public void Cover(CreatureMesh mesh, ReadOnlySpan<Vector3> joints, ReadOnlySpan<Quaternion> turns, FoldRoom room)
    {
        var at = new Vector3[mesh.Positions.Length];
        bool[] wing = new bool[at.Length];
        for (int v = 0; v < at.Length; v++)
        {
            Place place = PlaceOf(chain, mesh.Positions[v], mesh.Weights[v]);
            wing[v] = place.Still < 1f - MinFraction;
            at[v] = wing[v] ? Spot.Of(chain, place).At(joints, turns) : default;
        }

        ReadOnlySpan<int> triangles = mesh.Triangles;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            if (wing[triangles[t]] && wing[triangles[t + 1]] && wing[triangles[t + 2]])
            {
                room.Cover(at[triangles[t]], at[triangles[t + 1]], at[triangles[t + 2]]);
            }
        }
    }

    /// <summary>Adds the middles of the parts of a triangle, none of them longer than a spacing.</summary>
    private static void Fill(List<Place> found, in Place a, in Place b, in Place c, double spacing)
    {
        double longest = Math.Max(Vec.Distance(a.Rest, b.Rest), Math.Max(Vec.Distance(b.Rest, c.Rest), Vec.Distance(c.Rest, a.Rest)));
        int parts = (int)Math.Floor(longest / spacing);
        for (int i = 0; i < parts; i++)
        {
            for (int j = 0; i + j < parts; j++)
            {
                float u = (i + (1f / 3f)) / parts;
                float v = (j + (1f / 3f)) / parts;
                found.Add(Place.Between(a, b, c, u, v));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Area(Vector3 a, Vector3 b, Vector3 c) => Vec.Length(Vec.Cross(b - a, c - a));

    private static T[] Some<T>(List<T> all, int max)
    {
        int stride = Math.Max(1, all.Count / max);
        var chosen = new List<T>();
        for (int i = 0; i < all.Count; i += stride)
        {
            chosen.Add(all[i]);
        }

        return chosen.ToArray();
    }

    private static Place PlaceOf(PairedChain chain, Vector3 rest, in SkinWeights weights)
    {
        if (!Moves(chain, weights))
        {
            return new Place(rest, Array.Empty<float>(), 1f, 0f, chain.Limb.Kind == LimbKind.Wing ? 0f : 1f);
        }

        float[] fractions = new float[chain.Count];
        float sum = 0f;
        float max = 0f;
        for (int k = 0; k < fractions.Length; k++)
        {
            fractions[k] = FractionOf(chain.JointAt(k), weights);
            sum += fractions[k];
            max = Math.Max(max, fractions[k]);
        }

        // A stitched wing grows out of the body, where its upper arm moves it.
        float still = 1f - sum;
        return new Place(rest, fractions, still, max, chain.Limb.Kind == LimbKind.Wing ? sum - fractions[0] : 1f);
    }

    /// <summary>Whether a joint of the wing moves what has these weights.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Moves(PairedChain chain, in SkinWeights weights)
    {
        for (int k = 0; k < chain.Count; k++)
        {
            int joint = chain.JointAt(k);
            if (weights.Joint0 == joint || weights.Joint1 == joint || weights.Joint2 == joint || weights.Joint3 == joint)
            {
                return true;
            }
        }

        return false;
    }

    private static float FractionOf(int joint, in SkinWeights weights) =>
        (weights.Joint0 == joint ? weights.Weights.X : 0f) + (weights.Joint1 == joint ? weights.Weights.Y : 0f) + (weights.Joint2 == joint ? weights.Weights.Z : 0f) + (weights.Joint3 == joint ? weights.Weights.W : 0f);

    /// <summary>A place on the skin at rest, how much each joint of the wing, and the body, moves it, the most of the former, and how far it is to keep off the body, 0..1.</summary>
    private readonly record struct Place(Vector3 Rest, float[] Fractions, float Still, float Max, float Clear)
    {
        /// <summary>How much a joint moves it: without a list none does.</summary>
        public float Fraction(int joint) => joint < Fractions.Length ? Fractions[joint] : 0f;

        public bool Bends => Math.Max(Still, Max) < MaxOfOne;

        public static Place Between(in Place a, in Place b, in Place c, float u, float v)
        {
            float w = 1f - u - v;
            float[] fractions = new float[Math.Max(a.Fractions.Length, Math.Max(b.Fractions.Length, c.Fractions.Length))];
            for (int k = 0; k < fractions.Length; k++)
            {
                fractions[k] = (a.Fraction(k) * w) + (b.Fraction(k) * u) + (c.Fraction(k) * v);
            }

            return a with { Rest = (a.Rest * w) + (b.Rest * u) + (c.Rest * v), Fractions = fractions, Still = (a.Still * w) + (b.Still * u) + (c.Still * v) };
        }
    }

    /// <summary>A place as the joints carry it along.</summary>
    /// <param name="Still">Its part that stays with the body.</param>
    /// <param name="Pulls">What the joints that move it make of it.</param>
    /// <param name="Clear">How far it is to keep off the body, 0..1.</param>
    private readonly record struct Spot(Vector3 Still, Pull[] Pulls, float Clear)
    {
        public static Spot Of(PairedChain chain, in Place place)
        {
            var pulls = new List<Pull>();
            for (int k = 0; k < place.Fractions.Length; k++)
            {
                if (place.Fractions[k] > 0f)
                {
                    pulls.Add(new Pull(k, place.Rest - chain.Points[k], place.Fractions[k]));
                }
            }

            return new Spot(place.Rest * place.Still, pulls.ToArray(), place.Clear);
        }

        /// <summary>Where it is.</summary>
        /// <param name="joints">Places of the joints.</param>
        /// <param name="turns">How they are turned in the model.</param>
        public Vector3 At(ReadOnlySpan<Vector3> joints, ReadOnlySpan<Quaternion> turns)
        {
            Vector3 at = Still;
            foreach (Pull pull in Pulls)
            {
                at += Vec.Scale(joints[pull.Bone] + Rotation.Rotate(turns[pull.Bone], pull.Arm), pull.Fraction);
            }

            return at;
        }
    }

    /// <summary>A joint of the wing, from there to a place at rest, and how much it moves that.</summary>
    private readonly record struct Pull(int Bone, Vector3 Arm, float Fraction);

    /// <summary>A triangle and twice its area at rest.</summary>
    private readonly record struct Crease(Spot A, Spot B, Spot C, double Area);
}

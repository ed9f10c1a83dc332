using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Animation.Strokes.Flight;

/// <summary>How a wing lies against the body that it belongs to: of the ways of folding that its kind has the one that fits best, found by trying one number after the other in ever smaller steps.</summary>
internal sealed class FoldedWing
{
    private const int MostPieces = 80;

    /// <summary>Share of the wing's joints from which on skin belongs to the wing.</summary>
    private const float LeastShare = 0.6f;

    private const int Rounds = 7;
    private const double FirstStep = 0.24;
    private const double Shrink = 0.6;

    /// <summary>By which part of what the others are shortened the upper arm is.</summary>
    private const float UpperArm = 0.35f;

    private readonly PairedChain chain;
    private readonly Piece[] pieces;
    private readonly Quaternion[] turns;
    private float length;

    private FoldedWing(PairedChain chain, Piece[] pieces)
    {
        this.chain = chain;
        this.pieces = pieces;
        turns = new Quaternion[chain.Count];
    }

    /// <summary>Share of its length that a bone keeps: the upper arm most of it, for there the skin bends.</summary>
    public float LengthOf(int bone) => bone == 0 ? 1f - (UpperArm * (1f - length)) : length;

    /// <summary>The turn of a joint of the left wing.</summary>
    public Quaternion Turn(int joint) => turns[joint];

    /// <summary>Fits a pair of wings to a body.</summary>
    public static FoldedWing Of(Creature creature, PairedChain chain, FoldRange range, FoldRoom room)
    {
        var wing = new FoldedWing(chain, PiecesOf(creature, chain));
        wing.Fold(wing.Search(range, room));
        return wing;
    }

    private WingFold Search(FoldRange range, FoldRoom room)
    {
        WingFold best = range.Usual;
        double least = Try(best, range, room);
        double step = FirstStep;
        for (int round = 0; round < Rounds; round++, step *= Shrink)
        {
            for (int number = 0; number < WingFold.Count; number++)
            {
                for (int sign = -1; sign <= 1; sign += 2)
                {
                    WingFold other = best.With(number, sign * step, range.Least, range.Most);
                    double cost = other == best ? least : Try(other, range, room);
                    (best, least) = cost < least ? (other, cost) : (best, least);
                }
            }
        }

        return best;
    }

    private double Try(in WingFold fold, FoldRange range, FoldRoom room)
    {
        Fold(fold);
        Span<Quaternion> carried = stackalloc Quaternion[chain.Count];
        Span<Vector3> joints = stackalloc Vector3[chain.Count];
        Quaternion turn = Quaternion.Identity;
        Vector3 place = chain.Points[0];
        for (int k = 0; k < chain.Count; k++)
        {
            joints[k] = place;
            turn = carried[k] = Rotation.Normalize(Rotation.Multiply(turn, turns[k]));
            place += Rotation.Rotate(turn, (chain.Points[k + 1] - chain.Points[k]) * LengthOf(k));
        }

        double sum = 0;
        foreach (Piece piece in pieces)
        {
            Vector3 at = piece.Rest * piece.Still;
            for (int k = 0; k < chain.Count; k++)
            {
                at += (joints[k] + Rotation.Rotate(carried[k], piece.Rest - chain.Points[k])) * piece.Weights[k];
            }

            sum += room.Cost(at, range.Closeness);
        }

        return sum / Math.Max(pieces.Length, 1);
    }

    /// <summary>Turns the joints as far as they can.</summary>
    private void Fold(in WingFold fold)
    {
        length = (float)fold.Length;
        Quaternion carried = Quaternion.Identity;
        for (int k = 0; k < turns.Length; k++)
        {
            Quaternion rest = JointFrame.Raised(chain.Axes[k], Vector3.UnitY);
            Quaternion target = JointFrame.Raised(fold.Direction(k), fold.Face);
            Quaternion wanted = Rotation.Multiply(target, Rotation.Inverse(rest));
            turns[k] = chain.Limit(k, Rotation.Multiply(Rotation.Inverse(carried), wanted));
            carried = Rotation.Normalize(Rotation.Multiply(carried, turns[k]));
        }
    }

    /// <summary>Pieces of the left wing's skin, evenly chosen.</summary>
    private static Piece[] PiecesOf(Creature creature, PairedChain chain)
    {
        var found = new List<Piece>();
        ReadOnlySpan<Vector3> positions = creature.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            SkinWeights weights = creature.Mesh.Weights[v];
            float sum = 0f;
            for (int k = 0; k < chain.Count; k++)
            {
                sum += ShareOf(chain.Limb.Joints[k], weights);
            }

            if (sum > LeastShare)
            {
                float[] shares = new float[chain.Count];
                for (int k = 0; k < shares.Length; k++)
                {
                    shares[k] = ShareOf(chain.Limb.Joints[k], weights);
                }

                found.Add(new Piece(positions[v], shares, 1f - sum));
            }
        }

        int stride = Math.Max(1, found.Count / MostPieces);
        var chosen = new List<Piece>();
        for (int i = 0; i < found.Count; i += stride)
        {
            chosen.Add(found[i]);
        }

        return chosen.ToArray();
    }

    private static float ShareOf(int joint, in SkinWeights weights) =>
        (weights.Joint0 == joint ? weights.Weights.X : 0f) + (weights.Joint1 == joint ? weights.Weights.Y : 0f) + (weights.Joint2 == joint ? weights.Weights.Z : 0f) + (weights.Joint3 == joint ? weights.Weights.W : 0f);

    /// <summary>A place on the skin at rest, and how much each joint of the wing, and the body, moves it.</summary>
    private readonly record struct Piece(Vector3 Rest, float[] Weights, float Still);
}

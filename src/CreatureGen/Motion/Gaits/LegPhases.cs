using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>When in the cycle each foot comes down. Derive from it to make rules of your own.</summary>
public abstract class LegPhases
{
    /// <summary>Lag of a foot's touchdown.</summary>
    /// <param name="row">Pair of legs, 0 the rearmost.</param>
    /// <param name="rows">Number of pairs.</param>
    /// <param name="side">Left or right.</param>
    /// <param name="duty">Part of the cycle that a foot is down.</param>
    /// <returns>Part of a cycle; only its fraction counts.</returns>
    public abstract float Lag(int row, int rows, Side side, float duty);

    /// <summary>
    /// Leaps, as of grasshoppers: the hindmost pair pushes together, and after a flight all other legs catch the body together; they leave the ground when the hind feet have come down again.
    /// For any number of pairs from two on.
    /// </summary>
    public static LegPhases Leaping() => new LeapPhases();

    /// <summary>Touchdowns given for each leg; pairs beyond those listed repeat them from the rear.</summary>
    /// <param name="lags">Rear left, rear right, then the next pair ahead, part of a cycle.</param>
    /// <exception cref="ArgumentException">Their number is odd or nought, or one is not finite.</exception>
    public static LegPhases Listed(params float[] lags) => new ListedPhases(lags);

    /// <summary>Touchdowns given for the rearmost and the foremost pair, part of a cycle; those of pairs between lie evenly between them, so that canters and gallops roll along bodies of any number of legs.</summary>
    /// <exception cref="ArgumentException">One is not finite.</exception>
    public static LegPhases Spread(float rearLeft, float rearRight, float frontLeft, float frontRight) => new SpreadPhases(rearLeft, rearRight, frontLeft, frontRight);

    /// <summary>
    /// Steps that run along the body as a wave, left and right half a cycle apart: for any number of legs. By the classical rule a leg comes down when the one behind it has,
    /// a swing later: with a duty of one half that is the insects' tripod, with two thirds the tetrapod, with five sixths one leg after the other.
    /// </summary>
    /// <param name="direction">Which way they run.</param>
    /// <param name="waves">Waves from the first pair to the last, 0 to 64; 0 for each pair a swing later than its neighbour.</param>
    /// <exception cref="ArgumentException">The waves are out of range.</exception>
    public static LegPhases Wave(WaveDirection direction, float waves = 0f) => new WavePhases(direction, waves);
}

/// <summary>Touchdowns given for each leg.</summary>
internal sealed class ListedPhases : LegPhases
{
    private readonly float[] lags;

    /// <summary>Takes the lags: rear left, rear right, then the next pair ahead, part of a cycle.</summary>
    /// <exception cref="ArgumentException">Their number is odd or nought, or one is not finite.</exception>
    public ListedPhases(params float[] lags)
    {
        if (lags == null || lags.Length == 0 || lags.Length % 2 != 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"{lags?.Length ?? 0} lags; expected two for each pair of legs"), nameof(lags));
        }

        foreach (float lag in lags)
        {
            Finite.Require(lag, nameof(lags));
        }

        this.lags = (float[])lags.Clone();
    }

    /// <summary>Number of pairs of legs that are listed; further pairs repeat them from the rear.</summary>
    public int Rows => lags.Length / 2;

    /// <inheritdoc/>
    public override float Lag(int row, int rows, Side side, float duty) => lags[(2 * (row % Rows)) + (side == Side.Right ? 1 : 0)];
}

/// <summary>Touchdowns given for the rearmost and the foremost pair; those of pairs between lie evenly between them, so that canters and gallops roll along bodies of any number of legs.</summary>
internal sealed class SpreadPhases : LegPhases
{
    private readonly float rearLeft;
    private readonly float rearRight;
    private readonly float frontLeft;
    private readonly float frontRight;

    /// <summary>Takes the lags of the rearmost and the foremost pair, part of a cycle.</summary>
    /// <exception cref="ArgumentException">One is not finite.</exception>
    public SpreadPhases(float rearLeft, float rearRight, float frontLeft, float frontRight)
    {
        Finite.Require(rearLeft, nameof(rearLeft));
        Finite.Require(rearRight, nameof(rearRight));
        Finite.Require(frontLeft, nameof(frontLeft));
        Finite.Require(frontRight, nameof(frontRight));
        this.rearLeft = rearLeft;
        this.rearRight = rearRight;
        this.frontLeft = frontLeft;
        this.frontRight = frontRight;
    }

    /// <inheritdoc/>
    public override float Lag(int row, int rows, Side side, float duty)
    {
        float rear = side == Side.Right ? rearRight : rearLeft;
        float front = side == Side.Right ? frontRight : frontLeft;
        return row == 0 ? rear : row == rows - 1 ? front : Scalar.Lerp(rear, front, row / (rows - 1f));
    }
}

/// <summary>Which way steps run along the body.</summary>
public enum WaveDirection
{
    /// <summary>From the rear to the front, as in insects, millipedes and sprawlers.</summary>
    Forward,

    /// <summary>From the front to the rear, as in many centipedes.</summary>
    Backward,
}

/// <summary>
/// Steps that run along the body as a wave, left and right half a cycle apart: for any number of legs. By the classical rule a leg comes down when the one behind it has,
/// a swing later: with a duty of one half that is the insects' tripod, with two thirds the tetrapod, with five sixths one leg after the other.
/// </summary>
internal sealed class WavePhases : LegPhases
{
    private readonly WaveDirection direction;
    private readonly float waves;

    /// <summary>Each pair a swing later than its neighbour.</summary>
    public WavePhases(WaveDirection direction)
        : this(direction, 0f)
    {
    }

    /// <summary>A given number of waves along the body.</summary>
    /// <param name="direction">Which way they run.</param>
    /// <param name="waves">Waves from the first pair to the last; 0 for each pair a swing later than its neighbour.</param>
    public WavePhases(WaveDirection direction, float waves)
    {
        Finite.RequireWithin(waves, 0f, 64f, nameof(waves));
        this.direction = direction;
        this.waves = waves;
    }

    /// <inheritdoc/>
    public override float Lag(int row, int rows, Side side, float duty)
    {
        float step = waves > 0f && rows > 1 ? waves / (rows - 1) : 1f - duty;
        float along = direction == WaveDirection.Forward ? row : rows - 1 - row;
        return (along * step) + (side == Side.Right ? 0.5f : 0f);
    }
}

/// <summary>
/// Leaps, as of grasshoppers: the hindmost pair pushes together, and after a flight all other legs catch the body together; they leave the ground when the hind feet have come down again.
/// For any number of pairs from two on.
/// </summary>
internal sealed class LeapPhases : LegPhases
{
    /// <summary>Part of their stance that the catching legs stay down beside the hind legs.</summary>
    private const float Overlap = 0.3f;

    /// <inheritdoc/>
    public override float Lag(int row, int rows, Side side, float duty) => row == 0 ? 0f : 1f - ((1f - Overlap) * duty);
}

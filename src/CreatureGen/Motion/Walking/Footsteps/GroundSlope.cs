using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>The rise of the ground along the way, as the feet feel it: the line through their places, over some steps, so that hills no longer than the body do not count.</summary>
internal struct GroundSlope
{
    /// <summary>How quickly it follows, per second, and besides for each leg length that the body goes.</summary>
    private const float Rate = 3f;
    private const float RateOfWay = 1f;

    /// <summary>The steepest that is taken for a slope.</summary>
    private const float Steepest = 0.6f;

    /// <summary>Spread of the feet along the way, leg lengths, below which they say little: they stand side by side.</summary>
    private const float MinSpread = 0.05f;

    private ExponentialDecay decay;
    private float together;
    private float spread;

    /// <summary>Metres up for each metre ahead.</summary>
    public float Rise { get; private set; }

    /// <summary>Feels the ground under all feet.</summary>
    /// <param name="feet">Their places as last posed.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="dt">Seconds since the last time.</param>
    public void Feel(ReadOnlySpan<Foot> feet, float legLength, float speed, float dt)
    {
        float fraction = decay.Fraction((Rate + (RateOfWay * Math.Abs(speed) / legLength)) * dt);
        Measure(feet, out float nowTogether, out float nowSpread);
        together += (nowTogether - together) * fraction;
        spread += (nowSpread - spread) * fraction;
        Settle(legLength);
    }

    /// <summary>Takes the ground under all feet as it is at present.</summary>
    public void Reset(ReadOnlySpan<Foot> feet, float legLength)
    {
        Measure(feet, out together, out spread);
        Settle(legLength);
    }

    private void Settle(float legLength)
    {
        float min = MinSpread * legLength;
        Rise = Scalar.Clamp(together / (spread + (min * min)), -Steepest, Steepest);
    }

    /// <summary>Mean product of the places' distances from their middle, ahead and up, and mean square of those ahead: of each foot where it leaves the ground and where it comes down, so that feet side by side tell of the way too.</summary>
    private static void Measure(ReadOnlySpan<Foot> feet, out float together, out float spread)
    {
        float z = 0f;
        float y = 0f;
        float zy = 0f;
        float zz = 0f;
        for (int i = 0; i < feet.Length; i++)
        {
            Vector3 start = feet[i].Path.Start;
            Vector3 end = feet[i].Path.End;
            z += start.Z + end.Z;
            y += start.Y + end.Y;
            zy += (start.Z * start.Y) + (end.Z * end.Y);
            zz += (start.Z * start.Z) + (end.Z * end.Z);
        }

        float fraction = 0.5f / feet.Length;
        together = (zy - (z * y * fraction)) * fraction;
        spread = (zz - (z * z * fraction)) * fraction;
    }
}

namespace CreatureGen.Maths;

/// <summary>Transcendental functions built from basic arithmetic alone, so that every platform gives the same bits.</summary>
/// <remarks>
/// <para>Only +, −, ×, ÷ and the square root of IEEE 754 doubles, each rounded once, and operations on their bits are used; never the C runtime, and never a fused multiply-add.
/// Every function is defined for every double. The error bounds in units in the last place (ulp) are the largest seen against a reference of 200 and more bits
/// at random and at hard points; the tests hold them.</para>
/// <para>Special values follow IEEE 754-2019, section 9.2: NaN in gives NaN out (except <c>Pow(x, 0)</c> = <c>Pow(1, y)</c> = 1), arguments outside the
/// domain give NaN, and odd functions keep the sign of zero. No function throws.</para>
/// </remarks>
internal static partial class PortableMath
{
    /// <summary>Half the circumference of the unit circle.</summary>
    public const double Pi = 3.14159265358979323846;

    /// <summary>The circumference of the unit circle.</summary>
    public const double Tau = 6.28318530717958647692;

    /// <summary>What π has beyond <see cref="Pi"/>.</summary>
    private const double PiRest = 1.2246467991473532e-16;

    /// <summary>Below this an odd function with slope 1 at zero and a cubic term no larger than x³/2 rounds to its argument.</summary>
    private const double TinyArgument = 1.0 / (1 << 27);

    /// <summary>1.5 · 2^52: adding and subtracting it rounds a small number to the nearest whole one, ties to even.</summary>
    private const double RoundingShift = 6755399441055744.0;
}

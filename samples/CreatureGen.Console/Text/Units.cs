using System.Globalization;

namespace CreatureGen.Console.Text;

/// <summary>Numbers with their units, for people; the same in every culture, in plain ASCII.</summary>
internal static class Units
{
    /// <summary>A count, with commas between thousands.</summary>
    public static string Count(long number) => number.ToString("N0", CultureInfo.InvariantCulture);

    /// <summary>Metres with two decimals.</summary>
    public static string Metres(float metres) => metres.ToString("0.00", CultureInfo.InvariantCulture);

    /// <summary>Kilograms, in three digits or a little more.</summary>
    public static string Kilograms(float mass) => mass.ToString(mass < 10 ? "0.00" : mass < 100 ? "0.0" : "#,0", CultureInfo.InvariantCulture) + " kg";

    /// <summary>A part of a whole.</summary>
    public static string Percent(double part) => (part * 100).ToString("0", CultureInfo.InvariantCulture) + "%";

    /// <summary>A number without decimals.</summary>
    public static string Whole(float number) => number.ToString("0", CultureInfo.InvariantCulture);

    /// <summary>A number with one decimal.</summary>
    public static string Tenths(float number) => number.ToString("0.0", CultureInfo.InvariantCulture);

    /// <summary>A length of 1 as 100, with two decimals.</summary>
    public static string Hundredths(float length) => (length * 100f).ToString("0.00", CultureInfo.InvariantCulture);

    /// <summary>A short time.</summary>
    public static string Milliseconds(double milliseconds) => milliseconds.ToString(milliseconds < 9.95 ? "0.0" : "#,0", CultureInfo.InvariantCulture) + " ms";

    /// <summary>A size of a file.</summary>
    public static string Bytes(long bytes) => bytes switch
    {
        < 1000 => bytes.ToString(CultureInfo.InvariantCulture) + " bytes",
        < 999_500 => (bytes / 1e3).ToString("0", CultureInfo.InvariantCulture) + " kB",
        _ => (bytes / 1e6).ToString("0.0", CultureInfo.InvariantCulture) + " MB",
    };
}

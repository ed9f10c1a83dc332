using System;
using System.Globalization;
using System.Reflection;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using System.Runtime.Versioning;

namespace CreatureGen.Digest;

/// <summary>What the bytes of a creature must not depend on.</summary>
public static class Surroundings
{
    /// <summary>They as text, for remarks: the build of the library, what vector instructions the runtime uses, and how the culture writes a number.</summary>
    public static string Describe()
    {
        string library = typeof(CreatureGenerator).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;
        return $"library={library} vector128={Vector128.IsHardwareAccelerated} avx2={Avx2.IsSupported} number={-1234567.5}";
    }

    /// <summary>Makes a culture that of all threads. A machine without it, or without its data, gets one that writes numbers in a way of its own.</summary>
    public static void Enter(string name)
    {
        CultureInfo culture = Find(name) is CultureInfo found && Differs(found) ? found : Odd();
        CultureInfo.DefaultThreadCurrentCulture = culture;
        CultureInfo.DefaultThreadCurrentUICulture = culture;
        CultureInfo.CurrentCulture = culture;
        CultureInfo.CurrentUICulture = culture;
    }

    private static CultureInfo? Find(string name)
    {
        try
        {
            return CultureInfo.GetCultureInfo(name);
        }
        catch (CultureNotFoundException)
        {
            return null;
        }
    }

    private static bool Differs(CultureInfo culture) => (-1234567.5).ToString(culture) != (-1234567.5).ToString(CultureInfo.InvariantCulture);

    private static CultureInfo Odd()
    {
        var culture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        culture.NumberFormat.NegativeSign = "minus";
        culture.NumberFormat.PositiveSign = "plus";
        culture.NumberFormat.NumberDecimalSeparator = ",";
        culture.NumberFormat.NumberGroupSeparator = ".";
        culture.NumberFormat.PercentDecimalSeparator = ",";
        culture.NumberFormat.NaNSymbol = "none";
        culture.DateTimeFormat.DateSeparator = "~";
        return culture;
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace CreatureGen.Tests.Conventions;

/// <summary>What the determinism contract (docs/architecture.md section 4) keeps out of the library, told apart by compiled uses.</summary>
internal static class BannedUse
{
    private const string PortableMath = "the C runtime's or the processor's functions differ by platform; Maths/PortableMath has portable ones";
    private const string Vectors = "may fuse or reorder by processor and runtime; Maths/Vec and Maths/Rotation have portable ones";
    private const string Clock = "reads the clock; time enters as dt alone";
    private const string Machine = "reads or changes the machine; input and output are streams";
    private const string Threads = "threads inside a stage; parallelism is across creatures";
    private const string HashOrder = "enumerates in the order of hashes";

    /// <summary>Types that may not be used at all.</summary>
    private static readonly Dictionary<string, string> Types = new(StringComparer.Ordinal)
    {
        ["System.Random"] = "Seeding is the only randomness",
        ["System.Security.Cryptography.RandomNumberGenerator"] = "Seeding is the only randomness",
        ["System.HashCode"] = "its seed differs in every process",
        ["System.DateTime"] = Clock,
        ["System.DateTimeOffset"] = Clock,
        ["System.TimeProvider"] = Clock,
        ["System.Diagnostics.Stopwatch"] = Clock,
        ["System.Console"] = Machine,
        ["System.AppContext"] = Machine,
        ["System.IO.File"] = Machine,
        ["System.IO.FileStream"] = Machine,
        ["System.IO.Directory"] = Machine,
        ["System.IO.Path"] = Machine,
        ["System.Diagnostics.Process"] = Machine,
        ["System.Activator"] = "reflection; the library can be trimmed and compiled ahead of time",
        ["System.Threading.Tasks.Parallel"] = Threads,
        ["System.Threading.Thread"] = Threads,
        ["System.Threading.ThreadPool"] = Threads,
        ["System.Linq.ParallelEnumerable"] = Threads,
        ["System.Numerics.Vector"] = Vectors,
        ["System.Numerics.Vector`1"] = Vectors,
        ["System.Collections.Generic.KeyValuePair`2"] = HashOrder,
        ["System.Collections.Concurrent.ConcurrentDictionary`2"] = HashOrder,
        ["System.Collections.Concurrent.ConcurrentBag`1"] = HashOrder,
    };

    /// <summary>Namespaces that may not be used at all.</summary>
    private static readonly Dictionary<string, string> Namespaces = new(StringComparer.Ordinal)
    {
        ["System.Runtime.Intrinsics"] = Vectors,
        ["System.Numerics.Tensors"] = Vectors,
        ["System.Net"] = Machine,
        ["System.Reflection"] = "reflection; the library can be trimmed and compiled ahead of time",
    };

    /// <summary>Single members that may not be used, of types that may.</summary>
    private static readonly Dictionary<string, string> Members = new(StringComparer.Ordinal)
    {
        ["System.Guid.NewGuid"] = "Seeding is the only randomness",
        ["System.Globalization.CultureInfo.get_CurrentCulture"] = "the culture of the machine",
        ["System.Globalization.CultureInfo.get_CurrentUICulture"] = "the culture of the machine",
        ["System.Globalization.CultureInfo.get_InstalledUICulture"] = "the culture of the machine",
        ["System.Globalization.NumberFormatInfo.get_CurrentInfo"] = "the culture of the machine",
        ["System.StringComparer.get_CurrentCulture"] = "the culture of the machine",
        ["System.StringComparer.get_CurrentCultureIgnoreCase"] = "the culture of the machine",
        ["System.String.GetHashCode"] = "differs in every process",
        ["System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode"] = "differs in every run",
    };

    /// <summary>The one type that may use threads: it runs parts of a piece of work that know nothing of each other.</summary>
    private const string ThreadedType = "CreatureGen.Concurrency.IndependentParts";

    /// <summary>The one type that may work on sixteen bytes at a time: on whole numbers every operation is exact.</summary>
    private const string WideBytesType = "CreatureGen.Png.RowFilters";

    /// <summary>Types of which only some members may be used: those that are exact or correctly rounded everywhere.</summary>
    private static readonly Dictionary<string, (string[] Allowed, string Reason)> Partly = new(StringComparer.Ordinal)
    {
        // The compiler's own iterators ask which thread they are on.
        ["System.Environment"] = (["get_CurrentManagedThreadId"], Machine),
        ["System.Math"] = (["Sqrt", "Abs", "Min", "Max", "Floor", "Ceiling", "Round", "Truncate", "Sign", "Clamp", "DivRem", "PI", "BigMul"], PortableMath),
        ["System.MathF"] = (["Sqrt", "Abs", "Min", "Max", "Floor", "Ceiling", "Round", "Truncate", "Sign", "PI"], PortableMath),
        ["System.Numerics.Vector2"] = (["X", "Y", "get_Zero", "get_One", "get_UnitX", "get_UnitY", "Equals"], Vectors),
        ["System.Numerics.Vector3"] = (["X", "Y", "Z", "get_Zero", "get_One", "get_UnitX", "get_UnitY", "get_UnitZ", "Equals"], Vectors),
        ["System.Numerics.Vector4"] = (["X", "Y", "Z", "W", "get_Zero", "get_One", "get_UnitX", "get_UnitY", "get_UnitZ", "get_UnitW", "Equals"], Vectors),
        ["System.Numerics.Quaternion"] = (["X", "Y", "Z", "W", "get_Identity", "Equals", "op_Equality", "op_Inequality"], Vectors),
        ["System.Numerics.Matrix4x4"] =
            ([.. from row in Enumerable.Range(1, 4) from column in Enumerable.Range(1, 4) select $"M{row}{column}", "get_Identity", "Equals", "op_Equality", "op_Inequality"], Vectors),
        ["System.Runtime.Intrinsics.Vector128"] = (["Create", "Shuffle", "GetElement", "ToScalar", "AsVector128", "AsVector128Unsafe", "AsVector3", "AsQuaternion", "AsSingle", "LoadUnsafe", "StoreUnsafe", "LessThan", "ConditionalSelect", "Sqrt"], Vectors),
        ["System.Runtime.Intrinsics.Vector128`1"] = (["op_Addition", "op_Subtraction", "op_Multiply", "op_Division", "op_ExclusiveOr"], Vectors),
        ["System.Runtime.Intrinsics.Vector256"] = (["Create", "Shuffle", "AsSingle", "GetLower", "GetUpper", "LoadUnsafe", "StoreUnsafe", "LessThan", "LessThanAny", "ConditionalSelect", "Sqrt"], Vectors),
        ["System.Runtime.Intrinsics.Vector256`1"] = (["op_Addition", "op_Multiply", "op_Division"], Vectors),
    };

    /// <summary>Arithmetic of vectors that works on each component alone.</summary>
    private static readonly string[] Componentwise = ["op_Addition", "op_Subtraction", "op_Multiply", "op_Division", "op_UnaryNegation", "op_Equality", "op_Inequality"];

    /// <summary>Functions that later frameworks also offer on the number types themselves.</summary>
    private static readonly string[] NumberFunctions =
    [
        "Sin", "Cos", "Tan", "SinCos", "Asin", "Acos", "Atan", "Atan2", "Sinh", "Cosh", "Tanh", "Exp", "Exp2", "Exp10", "Log", "Log2", "Log10", "LogP1", "ExpM1",
        "Pow", "Cbrt", "RootN", "Hypot", "SinPi", "CosPi", "TanPi", "FusedMultiplyAdd", "MultiplyAddEstimate", "ReciprocalEstimate", "ReciprocalSqrtEstimate", "Lerp",
    ];

    private static readonly string[] Hashed = ["System.Collections.Generic.Dictionary`2", "System.Collections.Generic.HashSet`1"];

    /// <summary>Why a use is not allowed; null when it is.</summary>
    public static string? Reason(CompiledUse use)
    {
        if (use.Outer.FullName == WideBytesType && IsOfWholeNumbers(use.Target))
        {
            return null;
        }

        string type = use.TargetName;
        if (use.Outer.FullName == ThreadedType && type is "System.Threading.Tasks.Parallel" or "System.Environment")
        {
            return null;
        }

        string member = use.Target is Type ? "" : use.Target.Name;
        if (Types.TryGetValue(type, out string? reason) || Members.TryGetValue(type + "." + member, out reason))
        {
            return reason;
        }

        if (Partly.TryGetValue(type, out (string[] Allowed, string Reason) rule))
        {
            bool componentwise = type.StartsWith("System.Numerics.Vector", StringComparison.Ordinal) && Componentwise.Contains(member);
            return use.Target is Type or ConstructorInfo || componentwise || rule.Allowed.Contains(member) ? null : rule.Reason;
        }

        string space = use.TargetType.Namespace ?? "";
        string? banned = Namespaces.Keys.FirstOrDefault(n => space == n || space.StartsWith(n + ".", StringComparison.Ordinal));
        if (banned != null)
        {
            return Namespaces[banned];
        }

        if (type is "System.Double" or "System.Single" or "System.Half" && NumberFunctions.Contains(member))
        {
            return PortableMath;
        }

        return Hashed.Contains(type) && member is "GetEnumerator" or "get_Keys" or "get_Values" ? HashOrder : null;
    }

    /// <summary>Whether a member or type of vectors has whole numbers in its lanes alone.</summary>
    private static bool IsOfWholeNumbers(MemberInfo target)
    {
        Type[] mentioned = target switch
        {
            Type type => [type],
            MethodInfo method => [method.DeclaringType!, method.ReturnType, .. method.GetParameters().Select(p => p.ParameterType), .. method.GetGenericArguments()],
            _ => [target.DeclaringType!],
        };
        return mentioned.All(t => t.Namespace == "System.Runtime.Intrinsics" || t.Namespace == "System") && !mentioned.SelectMany(SimdKernels).Any(t => t == typeof(float) || t == typeof(double));
    }

    private static IEnumerable<Type> SimdKernels(Type type) => type.IsByRef ? SimdKernels(type.GetElementType()!) : type.IsGenericType ? type.GetGenericArguments() : [type];
}

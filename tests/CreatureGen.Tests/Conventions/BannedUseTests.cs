using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Reflection;
using System.Runtime.CompilerServices;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed class BannedUseTests
{
    [Fact]
    public void The_library_uses_nothing_that_the_determinism_contract_keeps_out()
    {
        var wrong = new SortedSet<string>(StringComparer.Ordinal);
        int uses = 0;
        foreach (CompiledUse use in CompiledUse.Of(typeof(CreatureGenerator).Assembly))
        {
            uses++;
            if (BannedUse.Reason(use) is string reason)
            {
                wrong.Add($"{use}: {reason}");
            }
        }

        Assert.True(uses > 10000, "the scan saw almost nothing");
        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    [Fact]
    public void The_library_has_no_static_state_but_scratch_memory_of_each_thread()
    {
        const BindingFlags Static = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        string[] wrong = typeof(CreatureGenerator).Assembly.GetTypes()
            .SelectMany(t => t.GetFields(Static))
            .Where(f => !f.IsLiteral && !f.IsInitOnly && !IsGenerated(f) && !f.IsDefined(typeof(ThreadStaticAttribute), false))
            .Select(f => $"{f.DeclaringType!.FullName}.{f.Name}")
            .ToArray();
        Assert.True(wrong.Length == 0, "static fields that can change: " + string.Join(", ", wrong));
    }

    [Fact]
    public void The_scan_sees_each_thing_that_is_kept_out()
    {
        MethodInfo[] bad = typeof(Bad).GetMethods(BindingFlags.Static | BindingFlags.Public);
        Assert.True(bad.Length >= 12);
        string[] reported = CompiledUse.Of(typeof(Bad)).Where(u => BannedUse.Reason(u) != null).Select(u => u.Method).Distinct().ToArray();
        Assert.Equal(bad.Select(m => m.Name).Order(StringComparer.Ordinal), reported.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void The_scan_lets_exact_arithmetic_pass() => Assert.Empty(CompiledUse.Of(typeof(Good)).Select(BannedUse.Reason).OfType<string>());

    private static bool IsGenerated(FieldInfo field) =>
        field.IsDefined(typeof(CompilerGeneratedAttribute), false) || field.DeclaringType!.IsDefined(typeof(CompilerGeneratedAttribute), false);

    private static class Bad
    {
        public static object Randomness() => new Random(1);

        public static int Hash() => HashCode.Combine(1, 2);

        public static int TextHash() => "text".GetHashCode(StringComparison.Ordinal);

        public static long Date() => DateTime.UtcNow.Ticks;

        public static int Ticks() => Environment.TickCount;

        public static object Culture() => System.Globalization.CultureInfo.CurrentCulture;

        public static double Sine(double x) => Math.Sin(x);

        public static float Power(float x) => MathF.Pow(x, 3f);

        public static double NumberSine(double x) => double.Sin(x);

        public static float Fused(float x) => MathF.FusedMultiplyAdd(x, x, x);

        public static float Dot(Vector3 v) => Vector3.Dot(v, v);

        public static float Length(Vector3 v) => v.Length();

        public static Vector3 Turned(Vector3 v, Quaternion q) => Vector3.Transform(v, q);

        public static Quaternion Product(Quaternion q) => q * q;

        public static Matrix4x4 MatrixProduct(Matrix4x4 m) => m * m;

        public static bool Wide() => System.Runtime.Intrinsics.Vector128.IsHardwareAccelerated;

        public static float WideSum(Vector3 v) => System.Runtime.Intrinsics.Vector128.Sum(System.Runtime.Intrinsics.Vector128.AsVector128(v));

        public static bool Wider() => System.Runtime.Intrinsics.Vector256.IsHardwareAccelerated;

        public static int Keys(Dictionary<string, int> map)
        {
            int sum = 0;
            foreach (KeyValuePair<string, int> pair in map)
            {
                sum = (sum * 31) + pair.Value;
            }

            return sum;
        }

        public static int[] Values(Dictionary<string, int> map) => map.Select(p => p.Value).ToArray();

        public static int Members(HashSet<int> set)
        {
            int sum = 0;
            foreach (int member in set)
            {
                sum = (sum * 31) + member;
            }

            return sum;
        }

        public static object Together() => System.Threading.Tasks.Parallel.For(0, 2, _ => { });

        public static bool Exists() => System.IO.File.Exists("a");
    }

    private static class Good
    {
        public static float Root(float x) => MathF.Sqrt(MathF.Abs(x)) + (float)Math.Floor(x);

        public static Vector3 Sum(Vector3 v) => ((v + Vector3.UnitX) * 2f) - new Vector3(v.X, v.Y, v.Z);

        public static int Found(Dictionary<string, int> map) => map.TryGetValue("a", out int value) ? value : 0;

        public static Quaternion Same(Quaternion q) => q == Quaternion.Identity ? new Quaternion(q.X, q.Y, q.Z, q.W) : q;
    }
}

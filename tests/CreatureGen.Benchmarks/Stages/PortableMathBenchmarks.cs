using System;
using BenchmarkDotNet.Attributes;
using CreatureGen.Maths;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>The portable functions beside those of the C runtime, per call.</summary>
[MemoryDiagnoser]
public class PortableMathBenchmarks
{
    private readonly double[] arguments = PortableMathWork.Arguments();

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double Sin() => PortableMathWork.Sin(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double RuntimeSin() => PortableMathWork.RuntimeSin(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double SinCos() => PortableMathWork.SinCos(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double Pow() => PortableMathWork.Pow(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double RuntimePow() => PortableMathWork.RuntimePow(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double Exp() => PortableMathWork.Exp(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double RuntimeExp() => PortableMathWork.RuntimeExp(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double Log() => PortableMathWork.Log(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double Atan2() => PortableMathWork.Atan2(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double RuntimeAtan2() => PortableMathWork.RuntimeAtan2(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double Acos() => PortableMathWork.Acos(arguments);

    [Benchmark(OperationsPerInvoke = PortableMathWork.Count)]
    public double Cbrt() => PortableMathWork.Cbrt(arguments);
}

/// <summary>Sums of a function over arguments in (0, 1], so that no call can be left out.</summary>
internal static class PortableMathWork
{
    public const int Count = 1024;

    public static double[] Arguments()
    {
        double[] arguments = new double[Count];
        for (int i = 0; i < Count; i++)
        {
            arguments[i] = (i + 1) / (double)Count;
        }

        return arguments;
    }

    public static double Sin(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += PortableMath.Sin(x * 6);
        }

        return sum;
    }

    public static double RuntimeSin(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += Math.Sin(x * 6);
        }

        return sum;
    }

    public static double SinCos(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            PortableMath.SinCos(x * 6, out double sine, out double cosine);
            sum += sine + cosine;
        }

        return sum;
    }

    public static double Pow(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += PortableMath.Pow(x, 1.3);
        }

        return sum;
    }

    public static double RuntimePow(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += Math.Pow(x, 1.3);
        }

        return sum;
    }

    public static double Exp(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += PortableMath.Exp(x);
        }

        return sum;
    }

    public static double RuntimeExp(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += Math.Exp(x);
        }

        return sum;
    }

    public static double Log(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += PortableMath.Log(x);
        }

        return sum;
    }

    public static double Atan2(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += PortableMath.Atan2(x, 0.5 - x);
        }

        return sum;
    }

    public static double RuntimeAtan2(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += Math.Atan2(x, 0.5 - x);
        }

        return sum;
    }

    public static double Acos(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += PortableMath.Acos(x);
        }

        return sum;
    }

    public static double Cbrt(double[] arguments)
    {
        double sum = 0;
        foreach (double x in arguments)
        {
            sum += PortableMath.Cbrt(x);
        }

        return sum;
    }
}

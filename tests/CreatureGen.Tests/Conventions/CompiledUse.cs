using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Emit;

namespace CreatureGen.Tests.Conventions;

/// <summary>A place in compiled code that uses a type or a member.</summary>
/// <param name="User">The type whose code it is.</param>
/// <param name="Method">Name of the method; empty for declarations of the type itself.</param>
/// <param name="Target">The type, method, constructor or field that is used.</param>
internal sealed record CompiledUse(Type User, string Method, MemberInfo Target)
{
    private static readonly Dictionary<short, OpCode> Codes = typeof(OpCodes).GetFields().Select(f => (OpCode)f.GetValue(null)!).ToDictionary(c => c.Value);

    /// <summary>The type that is used, or whose member is.</summary>
    public Type TargetType => Definition(Target as Type ?? Target.DeclaringType!);

    /// <summary>The type that is used with its namespace, without type arguments.</summary>
    public string TargetName => TargetType.FullName ?? TargetType.Name;

    /// <summary>The outermost type of the code: what a file is named after.</summary>
    public Type Outer
    {
        get
        {
            Type type = User;
            while (type.DeclaringType != null)
            {
                type = type.DeclaringType;
            }

            return type;
        }
    }

    /// <inheritdoc/>
    public override string ToString() => $"{Outer.FullName}{(Method.Length > 0 ? "." + Method : "")} uses {TargetName}{(Target is Type ? "" : "." + Target.Name)}";

    /// <summary>All uses in an assembly: in signatures, in declarations of types and in the bodies of methods.</summary>
    public static IEnumerable<CompiledUse> Of(Assembly assembly) => assembly.GetTypes().SelectMany(Of);

    /// <summary>All uses in a type; those of types nested in it are not among them.</summary>
    public static IEnumerable<CompiledUse> Of(Type type)
    {
        const BindingFlags All = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
        IEnumerable<Type> declared = type.GetInterfaces().Concat(type.GetFields(All).Select(f => f.FieldType)).Concat(type.BaseType is Type parent ? [parent] : []);
        foreach (Type used in declared.SelectMany(Parts).Distinct())
        {
            yield return new CompiledUse(type, "", used);
        }

        foreach (MethodBase method in type.GetMethods(All).Concat<MethodBase>(type.GetConstructors(All)))
        {
            foreach (MemberInfo target in Targets(method).Distinct())
            {
                yield return new CompiledUse(type, method.Name, target);
            }
        }
    }

    private static IEnumerable<MemberInfo> Targets(MethodBase method)
    {
        var types = new List<Type>(method.GetParameters().Select(p => p.ParameterType));
        types.AddRange(method is MethodInfo { ReturnType: Type returned } ? [returned] : []);
        MethodBody? body = method.GetMethodBody();
        types.AddRange(body?.LocalVariables.Select(l => l.LocalType) ?? []);
        foreach (Type part in types.SelectMany(Parts))
        {
            yield return part;
        }

        foreach (MemberInfo member in body == null ? [] : Tokens(body.GetILAsByteArray()!).Select(t => Resolve(method, t)))
        {
            yield return member;
            IEnumerable<Type> arguments = member is MethodInfo { IsGenericMethod: true } generic ? generic.GetGenericArguments() : [];
            foreach (Type part in arguments.Concat(member is Type type ? [type] : [member.DeclaringType!]).SelectMany(Parts))
            {
                yield return part;
            }
        }
    }

    private static MemberInfo Resolve(MethodBase method, int token) =>
        method.Module.ResolveMember(token, method.DeclaringType!.GetGenericArguments(), method.IsGenericMethod ? method.GetGenericArguments() : [])!;

    /// <summary>The tokens of types and members in the body of a method.</summary>
    private static IEnumerable<int> Tokens(byte[] code)
    {
        int at = 0;
        while (at < code.Length)
        {
            short value = code[at++];
            if (value == 0xFE)
            {
                value = unchecked((short)(0xFE00 | code[at++]));
            }

            OperandType operand = Codes[value].OperandType;
            if (operand is OperandType.InlineField or OperandType.InlineMethod or OperandType.InlineTok or OperandType.InlineType)
            {
                yield return BitConverter.ToInt32(code, at);
            }

            at += operand switch
            {
                OperandType.InlineNone => 0,
                OperandType.ShortInlineBrTarget or OperandType.ShortInlineI or OperandType.ShortInlineVar => 1,
                OperandType.InlineVar => 2,
                OperandType.InlineI8 or OperandType.InlineR => 8,
                OperandType.InlineSwitch => 4 + (4 * BitConverter.ToInt32(code, at)),
                _ => 4,
            };
        }
    }

    /// <summary>A type without arrays, references and arguments, and the same of its arguments.</summary>
    private static IEnumerable<Type> Parts(Type type)
    {
        while (type.HasElementType)
        {
            type = type.GetElementType()!;
        }

        if (type.IsGenericParameter)
        {
            return [];
        }

        return type.IsGenericType ? type.GetGenericArguments().SelectMany(Parts).Prepend(Definition(type)) : [type];
    }

    private static Type Definition(Type type) => type is { IsGenericType: true, IsGenericTypeDefinition: false } ? type.GetGenericTypeDefinition() : type;
}

using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using CreatureGen.Tests.Conventions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>Compiles code for engines that are not here against the stand-ins for their types that lie beside it.</summary>
internal static class EngineSamples
{
    /// <summary>An assembly of all code below a folder, and of more that a test adds.</summary>
    public static Assembly Compile(string folder, LanguageVersion language, string more)
    {
        var options = new CSharpParseOptions(language);
        SyntaxTree[] trees = RepositoryFiles.Below(folder, "*.cs").Select(path => CSharpSyntaxTree.ParseText(RepositoryFiles.Text(path), options, path)).Append(CSharpSyntaxTree.ParseText(more, options, "test")).ToArray();
        IEnumerable<MetadataReference> references = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator).Select(path => MetadataReference.CreateFromFile(path));
        var bytes = new MemoryStream();
        var result = CSharpCompilation.Create(Path.GetFileName(folder) + "Sample", trees, references, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary)).Emit(bytes, cancellationToken: TestContext.Current.CancellationToken);
        string[] errors = result.Diagnostics.Where(problem => problem.Severity == DiagnosticSeverity.Error).Select(problem => problem.ToString()).ToArray();
        Assert.True(errors.Length == 0, string.Join('\n', errors));
        return Assembly.Load(bytes.ToArray());
    }

    /// <summary>Calls a method of the code that the test added.</summary>
    public static T Call<T>(this Assembly assembly, string method, params object[] arguments) => (T)assembly.GetType("Check", throwOnError: true)!.GetMethod(method)!.Invoke(null, arguments)!;
}

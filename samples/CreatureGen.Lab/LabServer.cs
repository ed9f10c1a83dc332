using System;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.StaticFiles;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.FileProviders;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;

namespace CreatureGen.Lab;

/// <summary>Serves the page to this machine and no other.</summary>
internal static class LabServer
{
    /// <summary>The page may run what came with it, and reach nothing else.</summary>
    private const string SecurityPolicy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; img-src 'self' blob: data:; font-src 'self'; connect-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    public static async Task RunAsync(Site site, int port)
    {
        WebApplicationBuilder builder = WebApplication.CreateSlimBuilder();
        builder.Logging.ClearProviders();
        builder.WebHost.ConfigureKestrel(kestrel => kestrel.Listen(System.Net.IPAddress.Loopback, port));
        WebApplication server = builder.Build();
        server.Use((context, next) =>
        {
            context.Response.Headers.ContentSecurityPolicy = SecurityPolicy;
            context.Response.Headers.XContentTypeOptions = "nosniff";
            context.Response.Headers.CacheControl = "no-cache";
            return next();
        });
        var types = new FileExtensionContentTypeProvider();
        types.Mappings[".wasm"] = "application/wasm";
        types.Mappings[".dll"] = "application/octet-stream";
        server.UseFileServer(new FileServerOptions { FileProvider = new PhysicalFileProvider(site.Folder), StaticFileOptions = { ContentTypeProvider = types } });
        try
        {
            await server.StartAsync();
        }
        catch (IOException reason)
        {
            throw new IOException(FormattableString.Invariant($"port {port} cannot be used: {reason.Message} Choose another with --port N"), reason);
        }

        int bound = new Uri(server.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>()!.Addresses.First()).Port;
        await System.Console.Out.WriteLineAsync(FormattableString.Invariant($"The creature lab is at http://localhost:{bound}/ (Ctrl+C ends it)"));
        await server.WaitForShutdownAsync();
    }
}

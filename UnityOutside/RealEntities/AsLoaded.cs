namespace RealEntities
{
    static class AsLoaded
    {
        /// <summary>Before any test: what Unity calls once scripts are loaded.</summary>
        [System.Runtime.CompilerServices.ModuleInitializer]
        internal static void Begin() => Loading.Once();
    }
}

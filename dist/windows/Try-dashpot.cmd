@echo off
rem The demonstration: a virtual damper is measured, identified, validated; another one is diagnosed.
chcp 65001 >nul
cd /d "%~dp0"
dashpot.exe demo -o demo
if errorlevel 1 goto wrong
start "" "demo\report.html"
goto end
:wrong
echo.
echo This did not work. The line above says why.
:end
if not "%DASHPOT_NO_PAUSE%"=="1" pause

@echo off
rem A folder of records (or one file) dragged onto this file: model and report go into a new folder beside it.
chcp 65001 >nul
if "%~1"=="" goto how
set "OUT=%~f1-dashpot"
if not exist "%OUT%" mkdir "%OUT%"
"%~dp0dashpot.exe" fit "%~1" -o "%OUT%\damper.toml"
if errorlevel 1 goto wrong
"%~dp0dashpot.exe" validate "%OUT%\damper.toml" "%~1" --report "%OUT%\report.html"
if errorlevel 1 goto wrong
start "" "%OUT%\report.html"
goto end
:how
echo Drag a folder with the records of one damper onto this file, and let go.
goto end
:wrong
echo.
echo This did not work. The line above says why, and what to do.
:end
if not "%DASHPOT_NO_PAUSE%"=="1" pause
